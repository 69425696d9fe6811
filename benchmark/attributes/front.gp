# Distance against error of colours on ten models.
#   gnuplot -e "table='front.csv'; plot='weights.png'" front.gp
set terminal pngcairo size 1500,640 font "sans,10" enhanced
set output plot
set datafile separator ","
names = system(sprintf("python3 -c \"import csv; print('|'.join(dict.fromkeys(r['model'] for r in csv.DictReader(open('%s')))))\"", table))
rows(model, contender) = sprintf("<python3 -c \"import csv; \
[print(r['shape'], r['colour'], r['weight'], sep=',') for r in csv.DictReader(open('%s')) \
if r['model'] == '%s' and r['contender'] == '%s']\"", table, model, contender)
default(model, contender) = sprintf("<python3 -c \"import csv; \
[print(r['shape'], r['colour'], sep=',') for r in csv.DictReader(open('%s')) \
if r['model'] == '%s' and r['contender'] == '%s' and r['weight'] == '1']\"", table, model, contender)
set logscale xy 2
set grid linecolor rgb "gray85"
set xtics auto
set format x "%.3g"
set format y "%.3g"
set key top right samplen 2
set multiplot layout 2,5
do for [i = 1:10] {
  model = system(sprintf("printf '%%s' '%s' | cut -d'|' -f%d", names, i))
  set title model noenhanced
  if (i > 5) { set xlabel "RMS distance, % of the diagonal" }
  if (i == 1 || i == 6) { set ylabel "RMS of colours" } else { unset ylabel }
  plot rows(model, "quadric") using 1:2 with linespoints linewidth 1.5 pointtype 7 pointsize 0.5 linecolor rgb "#d7191c" title "Quadrille, 0.1 to 10", \
    rows(model, "memoryless") using 1:2 with linespoints linewidth 1.5 pointtype 7 pointsize 0.5 linecolor rgb "#e6a101" title "memoryless", \
    rows(model, "meshoptimizer update") using 1:2 with linespoints linewidth 1.5 pointtype 5 pointsize 0.5 linecolor rgb "#2166ac" title "meshoptimizer, 0.01 to 5", \
    default(model, "quadric") using 1:2 with points pointtype 6 pointsize 2 linewidth 2 linecolor rgb "#d7191c" notitle, \
    default(model, "memoryless") using 1:2 with points pointtype 6 pointsize 2 linewidth 2 linecolor rgb "#e6a101" notitle
  unset key
}
unset multiplot
