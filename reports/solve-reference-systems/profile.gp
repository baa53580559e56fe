# Performance profile against IBEX with its linear relaxation
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' profile.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,277 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,7.32cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'profile.'.format
data = 'profile.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 73 mm

# CPU time
set label 'CPU time' at screen 0.07471,0.96174 left font ',8' tc rgb '#202020' noenhanced front
set label 'τ: CPU time over the least of the methods' at screen 0.29454,0.09292 center font ',7' tc rgb '#202020' noenhanced front
set label 'problems solved within τ [%]' at screen 0.01149,0.55534 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.02460 to screen 0.11207,0.02460 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.09339,0.02460 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'adaptive' at screen 0.12069,0.02460 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.35922,0.02460 to screen 0.39658,0.02460 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.37790,0.02460 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'IBEX 2.9 (not the same run)' at screen 0.40520,0.02460 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.07471; set rmargin at screen 0.51437
set bmargin at screen 0.17901; set tmargin at screen 0.93168
set logscale x
set xrange [1:105.04382005955587]
set xtics ('1' 1, '2' 2, '5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
unset logscale y
set yrange [0:102]
set ytics ('0' 0, '20' 20, '40' 40, '60' 60, '80' 80, '100' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:2 with steps lc rgb '#0072B2' dt 1 lw 1.4, \
  data index 0 using 1:2 every 2 with points pt 7 ps 0.45 lc rgb '#0072B2', \
  data index 1 using 1:2 with steps lc rgb '#D55E00' dt 1 lw 1.4, \
  data index 1 using 1:2 every 2 with points pt 5 ps 0.45 lc rgb '#D55E00'
unset label; unset arrow

# boxes
set label 'boxes' at screen 0.54310,0.96174 left font ',8' tc rgb '#202020' noenhanced front
set label 'τ: boxes over the least of the methods' at screen 0.76293,0.09292 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.98276
set bmargin at screen 0.17901; set tmargin at screen 0.93168
set logscale x
set xrange [1:10.342857142857142]
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
unset logscale y
set yrange [0:102]
set ytics ('' 0, '' 20, '' 40, '' 60, '' 80, '' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 2 using 1:2 with steps lc rgb '#0072B2' dt 1 lw 1.4, \
  data index 2 using 1:2 every 2 with points pt 7 ps 0.45 lc rgb '#0072B2', \
  data index 3 using 1:2 with steps lc rgb '#D55E00' dt 1 lw 1.4, \
  data index 3 using 1:2 every 2 with points pt 5 ps 0.45 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
