# Time against error, every contender a mark.
#   gnuplot -e "table='bunny00_7541.csv'; plot='bunny00_7541.png'" plot.gp
set terminal pngcairo size 1000,600 font "sans,11" enhanced
set output plot
set datafile separator ","
set datafile columnheaders

stats table using "min_ms" name "fastest" nooutput
stats table using "max_ms" name "slowest" nooutput
stats table using (1e4 * column("rms")) name "error" nooutput
contenders = int(error_records)
array name[contenders]
do for [i=1:contenders] {
  stats table every ::i-1::i-1 using (name[i]=strcol("contender"), model=strcol("model"), \
    input=column("input_faces"), target=column("target_faces"), 1) nooutput
}

set title sprintf("%s: %d to %d faces; low and left is good", model, input, target) noenhanced
set xlabel "processor time in ms, the median and the whole spread"
set ylabel "RMS distance in 10^{-4} of the bounding-box diagonal"
set logscale xy
set xrange [fastest_min / 1.4 : slowest_max * 1.4]
set yrange [error_min / 1.2 : error_max * 1.2]
set for [e=-3:7] xtics add (1 * 10.0**e, 2 * 10.0**e, 5 * 10.0**e) nomirror
set for [e=-5:4] ytics add (1 * 10.0**e, 1.5 * 10.0**e, 2 * 10.0**e, 3 * 10.0**e, 5 * 10.0**e, \
  7 * 10.0**e) nomirror
set format "%g"
set grid linecolor rgb "gray85"
set key outside right center vertical reverse Left spacing 1.3 noenhanced

# Ours are filled circles in warm colours; the marks of the others differ from each other.
is_ours(i) = name[i][1:9] eq "Quadrille"
colour(i) = is_ours(i) ? word("#d7191c #e66101 #f4a582 #e6a700 #c51b7d #8c510a", i) \
                       : name[i][1:4] eq "CGAL" ? "#2166ac" : "#4d9221"
mark(i) = is_ours(i) ? 7 : int(word("1 2 3 4 6 8 10 12 5 9 11 13 14", (i - 1) % 13 + 1))
plot for [i=1:contenders] table every ::i-1::i-1 \
  using "median_ms":(1e4*column("rms")):"min_ms":"max_ms" with xerrorbars \
  linecolor rgb colour(i) pointtype mark(i) pointsize 1.6 linewidth 1.5 title name[i]
