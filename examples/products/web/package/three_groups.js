// Groups of a geometry of three.js as labels of its triangles, and back.

/** The label of each triangle, which says in which groups it is; null where there are no groups. */
export function groupLabels(geometry, triangles) {
  if (geometry.groups.length === 0) return { labels: null, groupsOfLabel: [] };
  const groupsOfTriangle = Array.from({ length: triangles }, () => []);
  geometry.groups.forEach(({ start, count }, group) => {
    const end = Math.min(Math.floor((start + count) / 3), triangles);
    for (let triangle = Math.ceil(start / 3); triangle < end; ++triangle) groupsOfTriangle[triangle].push(group);
  });
  const numbers = new Map(), groupsOfLabel = [];
  const labels = Uint32Array.from(groupsOfTriangle, (groups) => {
    const key = groups.join();
    if (!numbers.has(key)) numbers.set(key, groupsOfLabel.push(groups) - 1);
    return numbers.get(key);
  });
  return { labels, groupsOfLabel };
}

/** The groups of what is left, in the order of those before: triangles keep their order, too. */
export function groupsOf(geometry, labels, groupsOfLabel) {
  return geometry.groups.flatMap(({ materialIndex }, group) => {
    const runs = [];
    labels.forEach((label, triangle) => {
      if (!groupsOfLabel[label].includes(group)) return;
      const last = runs.at(-1);
      if (last && last.start + last.count === 3 * triangle) last.count += 3;
      else runs.push({ start: 3 * triangle, count: 3, materialIndex });
    });
    return runs;
  });
}
