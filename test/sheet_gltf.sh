# For tests that are written in shell.

# Writes a glTF document, with its buffer in the text: a sheet of 8 x 8 quadrilaterals of bytes, and
# what a document may have beside meshes.
write_sheet() { # file
  sheet_of_bytes=$(awk 'BEGIN {
  n = 8
  for (i = 0; i <= n; ++i) for (j = 0; j <= n; ++j)
    printf "\\%03o\\%03o\\%03o\\000", 9 * i, 9 * j, i * j % 5
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
    v = i * (n + 1) + j
    printf "\\%03o\\%03o\\%03o\\%03o\\%03o\\%03o", v, v + n + 1, v + n + 2, v, v + n + 2, v + 1
  }
}')
  # shellcheck disable=SC2059
  cat >"$1" <<END
{"asset": {"version": "2.0"}, "extensions": {"VENDOR_any": {"x": [1, null]}},
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
 "materials": [{"name": "plain"}], "nodes": [{"mesh": 0}],
 "accessors": [{"bufferView": 0, "componentType": 5121, "type": "VEC3", "count": 81},
               {"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": 384}],
 "bufferViews": [{"buffer": 0, "byteLength": 324, "byteStride": 4},
                 {"buffer": 0, "byteOffset": 324, "byteLength": 384}],
 "buffers": [{"byteLength": 708, "uri": "data:application/octet-stream;base64,$(printf "$sheet_of_bytes" | base64 | tr -d '\n')"}]}
END
}
