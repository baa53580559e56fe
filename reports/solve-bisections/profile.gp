# Performance profiles of bisection strategies
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' profile.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,290 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,7.68cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'profile.'.format
data = 'profile.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 77 mm

# CPU time
set label 'CPU time' at screen 0.07471,0.96353 left font ',8' tc rgb '#202020' noenhanced front
set label 'τ: CPU time over the least of the methods' at screen 0.29454,0.13545 center font ',7' tc rgb '#202020' noenhanced front
set label 'problems solved within τ [%]' at screen 0.01149,0.57619 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.07033 to screen 0.11207,0.07033 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.09339,0.07033 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'combined smear' at screen 0.12069,0.07033 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.28642,0.07033 to screen 0.32377,0.07033 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.30509,0.07033 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'relative smear sum' at screen 0.33239,0.07033 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.49812,0.07033 to screen 0.53548,0.07033 nohead lc rgb '#009E73' dt 1 lw 1
set label '' at screen 0.51680,0.07033 point pt 9 ps 0.45 lc rgb '#009E73'
set label 'smear sum' at screen 0.54410,0.07033 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.70982,0.07033 to screen 0.74718,0.07033 nohead lc rgb '#E69F00' dt 1 lw 1
set label '' at screen 0.72850,0.07033 point pt 13 ps 0.45 lc rgb '#E69F00'
set label 'largest smear' at screen 0.75580,0.07033 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.02344 to screen 0.11207,0.02344 nohead lc rgb '#CC79A7' dt 1 lw 1
set label '' at screen 0.09339,0.02344 point pt 11 ps 0.45 lc rgb '#CC79A7'
set label 'longest side' at screen 0.12069,0.02344 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.28642,0.02344 to screen 0.32377,0.02344 nohead lc rgb '#56B4E9' dt 1 lw 1
set label '' at screen 0.30509,0.02344 point pt 6 ps 0.45 lc rgb '#56B4E9'
set label 'least reduced side' at screen 0.33239,0.02344 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.49812,0.02344 to screen 0.53548,0.02344 nohead lc rgb '#000000' dt 1 lw 1
set label '' at screen 0.51680,0.02344 point pt 4 ps 0.45 lc rgb '#000000'
set label 'round robin' at screen 0.54410,0.02344 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.07471; set rmargin at screen 0.51437
set bmargin at screen 0.21750; set tmargin at screen 0.93488
set logscale x
set xrange [1:137.45904609579296]
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
  data index 1 using 1:2 every 2 with points pt 5 ps 0.45 lc rgb '#D55E00', \
  data index 2 using 1:2 with steps lc rgb '#009E73' dt 1 lw 1.4, \
  data index 2 using 1:2 every 2 with points pt 9 ps 0.45 lc rgb '#009E73', \
  data index 3 using 1:2 with steps lc rgb '#E69F00' dt 1 lw 1.4, \
  data index 3 using 1:2 every 2 with points pt 13 ps 0.45 lc rgb '#E69F00', \
  data index 4 using 1:2 with steps lc rgb '#CC79A7' dt 1 lw 1.4, \
  data index 4 using 1:2 every 2 with points pt 11 ps 0.45 lc rgb '#CC79A7', \
  data index 5 using 1:2 with steps lc rgb '#56B4E9' dt 1 lw 1.4, \
  data index 5 using 1:2 every 1 with points pt 6 ps 0.45 lc rgb '#56B4E9', \
  data index 6 using 1:2 with steps lc rgb '#000000' dt 1 lw 1.4, \
  data index 6 using 1:2 every 2 with points pt 4 ps 0.45 lc rgb '#000000'
unset label; unset arrow

# boxes
set label 'boxes' at screen 0.54310,0.96353 left font ',8' tc rgb '#202020' noenhanced front
set label 'τ: boxes over the least of the methods' at screen 0.76293,0.13545 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.98276
set bmargin at screen 0.21750; set tmargin at screen 0.93488
set logscale x
set xrange [1:461.80075471698115]
set xtics ('1' 1, '10' 10, '100' 100)
unset logscale y
set yrange [0:102]
set ytics ('' 0, '' 20, '' 40, '' 60, '' 80, '' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 7 using 1:2 with steps lc rgb '#0072B2' dt 1 lw 1.4, \
  data index 7 using 1:2 every 2 with points pt 7 ps 0.45 lc rgb '#0072B2', \
  data index 8 using 1:2 with steps lc rgb '#D55E00' dt 1 lw 1.4, \
  data index 8 using 1:2 every 2 with points pt 5 ps 0.45 lc rgb '#D55E00', \
  data index 9 using 1:2 with steps lc rgb '#009E73' dt 1 lw 1.4, \
  data index 9 using 1:2 every 2 with points pt 9 ps 0.45 lc rgb '#009E73', \
  data index 10 using 1:2 with steps lc rgb '#E69F00' dt 1 lw 1.4, \
  data index 10 using 1:2 every 2 with points pt 13 ps 0.45 lc rgb '#E69F00', \
  data index 11 using 1:2 with steps lc rgb '#CC79A7' dt 1 lw 1.4, \
  data index 11 using 1:2 every 2 with points pt 11 ps 0.45 lc rgb '#CC79A7', \
  data index 12 using 1:2 with steps lc rgb '#56B4E9' dt 1 lw 1.4, \
  data index 12 using 1:2 every 1 with points pt 6 ps 0.45 lc rgb '#56B4E9', \
  data index 13 using 1:2 with steps lc rgb '#000000' dt 1 lw 1.4, \
  data index 13 using 1:2 every 2 with points pt 4 ps 0.45 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
