# Modules of JavaScript that npm fetches.
find_program(QUADRILLE_NPM npm)
find_program(QUADRILLE_NODE NAMES node nodejs)
mark_as_advanced(QUADRILLE_NPM QUADRILLE_NODE)

# quadrille_fetch_modules(source result): npm fetches what package.json in `source` names, the versions of
# package-lock.json, once, while CMake configures, into the folder that is being built. `result` says why it
# cannot be done, or is empty.
function(quadrille_fetch_modules source result)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}")
  set(${result} "" PARENT_SCOPE)
  if(NOT QUADRILLE_NPM OR NOT QUADRILLE_NODE)
    set(${result} "npm not found" PARENT_SCOPE)
    return()
  endif()
  file(SHA256 "${source}/package-lock.json" wanted)
  set(fetched "")
  if(EXISTS "${folder}/fetched.txt")
    file(READ "${folder}/fetched.txt" fetched)
  endif()
  if(fetched STREQUAL wanted)
    return()
  endif()
  message(STATUS "Fetching three.js and esbuild by npm")
  file(COPY "${source}/package.json" "${source}/package-lock.json" DESTINATION "${folder}")
  execute_process(
    COMMAND "${QUADRILLE_NPM}" ci --ignore-scripts --no-audit --no-fund --no-update-notifier
      --fetch-retries=1 --fetch-retry-mintimeout=1000 --fetch-timeout=20000
    WORKING_DIRECTORY "${folder}" TIMEOUT 120
    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    file(WRITE "${folder}/npm.log" "${output}")
    set(${result} "npm could not fetch three.js and esbuild, see ${folder}/npm.log" PARENT_SCOPE)
  else()
    file(WRITE "${folder}/fetched.txt" "${wanted}")
  endif()
endfunction()
