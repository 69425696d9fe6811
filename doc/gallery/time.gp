# Time against error, each contender a mark with its name.
#   gnuplot -e "table='time.csv'; plot='time.png'" time.gp
set terminal pngcairo size 900,460 font "DejaVu Sans,11" enhanced
set output plot
set datafile separator ","
set logscale xy
set xrange [28:3200]
set yrange [1.08:3.4]
set xtics (30, 50, 100, 200, 500, 1000, 2000)
set ytics (1.2, 1.5, 2, 2.5, 3)
set xlabel "milliseconds, one thread"
set ylabel "RMS distance in 10^{-4} of the diagonal"
set grid linecolor "#e4e4e4" linetype 1
set border 3 linecolor "#555555"
set tics nomirror textcolor "#333333"
unset key
is_ours(name) = strstrt(name, "Quadrille") == 1
short(name) = name eq "Quadrille" ? name : is_ours(name) ? substr(name, 11, 99) : name
# A name is above and to the right of its mark, but for one that would lie on another.
is_low(name) = name eq "Quadrille memoryless"
plot table using (is_ours(strcol(1)) ? $2 : NaN):3 with points pointtype 7 pointsize 1.6 linecolor "#c23b22", \
     table using (is_ours(strcol(1)) ? NaN : $2):3 with points pointtype 5 pointsize 1.2 linecolor "#888888", \
     table using (is_low(strcol(1)) ? NaN : $2):3:(short(strcol(1))) with labels left offset 0.8,0.6, \
     table using (is_low(strcol(1)) ? $2 : NaN):3:(short(strcol(1))) with labels right offset 0,-0.9
