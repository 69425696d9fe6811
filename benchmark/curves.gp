# Error against the number of faces, relative to CGAL's plane policies.
#   gnuplot -e "table='curves.csv'; plot='curves.png'" curves.gp
set terminal pngcairo size 1200,800 font "sans,11" enhanced
set output plot
rows(model, contender) = sprintf("<awk -F, '$1 == \"%s\" && $3 == \"CGAL GH plane\" {unit[$2] = $4} \
  $1 == \"%s\" && $3 == \"%s\" {faces[++n] = $2; rms[n] = $4} \
  END {for (i = 1; i <= n; i++) print faces[i], rms[i] / unit[faces[i]]}' %s", \
  model, model, contender, table)
names = "'Quadrille' 'Quadrille memoryless' 'Quadrille thin features' \
  'Quadrille relaxed refreshed' 'CGAL GH plane' 'CGAL Lindstrom-Turk'"
colours = "#d7191c #e66101 #1a9641 #8c510a #2166ac #92c5de"
set logscale x
set xlabel "faces"
set ylabel "RMS distance, CGAL GH plane = 1"
set xrange [50 : 20000]
set yrange [0.5 : 1.6]
set grid linecolor rgb "gray85"
set key top right noenhanced
set multiplot layout 2,2
do for [model in "cow fandisk_large armadillo bunny00"] {
  set title model noenhanced
  plot for [i=1:words(names)] rows(model, word(names, i)) using 1:2 with linespoints linewidth 1.5 \
    pointtype 7 linecolor rgb word(colours, i) title word(names, i)
  unset key
}
unset multiplot
