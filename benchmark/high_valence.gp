# Time against size at hubs.
#   gnuplot -e "table='high_valence.csv'; plot='high_valence.png'" high_valence.gp
set terminal pngcairo size 1200,800 font "sans,11" enhanced
set output plot
rows(shape, call) = sprintf("<awk -F, '$1 == \"%s\" && $2 == \"%s\" {print $3, $4}' %s", \
  shape, call, table)
calls = "'to 10 %' 'within 0.01' 'memoryless to 10 %' 'relaxed to 10 %'"
colours = "#d7191c #2166ac #e66101 #1a9641"
set logscale xy
set xlabel "faces"
set ylabel "seconds"
set xrange [2000 : 100000]
set yrange [0.001 : 10]
set format y "%g"
set grid linecolor rgb "gray85"
set key top left noenhanced
titles = "'a fan of teeth' 'a crown: two of them' 'fins on one edge' 'petals at one point'"
set multiplot layout 2,2
do for [k=1:4] {
  set title word(titles, k) noenhanced
  plot for [i=1:words(calls)] rows(word("fan crown fins petals", k), word(calls, i)) using 1:2 \
    with linespoints linewidth 1.5 pointtype 7 linecolor rgb word(colours, i) \
    title word(calls, i), \
    x / 40000 * 2 with lines linecolor rgb "gray60" dashtype 2 title "50 microseconds a face"
  unset key
}
unset multiplot
