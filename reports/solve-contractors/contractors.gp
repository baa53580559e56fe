# Contractors, all with the relative smear sum
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' contractors.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,304 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,8.04cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'contractors.'.format
data = 'contractors.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 80 mm

# CPU time
set label 'CPU time' at screen 0.07471,0.96517 left font ',8' tc rgb '#202020' noenhanced front
set label 'τ: CPU time over the least of the methods' at screen 0.29454,0.17417 center font ',7' tc rgb '#202020' noenhanced front
set label 'problems solved within τ [%]' at screen 0.01149,0.59517 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.11197 to screen 0.11207,0.11197 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.09339,0.11197 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'hull+multipliers, smear sum' at screen 0.12069,0.11197 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.35922,0.11197 to screen 0.39658,0.11197 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.37790,0.11197 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'hull+newton, smear sum' at screen 0.40520,0.11197 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.64373,0.11197 to screen 0.68109,0.11197 nohead lc rgb '#009E73' dt 1 lw 1
set label '' at screen 0.66241,0.11197 point pt 9 ps 0.45 lc rgb '#009E73'
set label 'newton, smear sum' at screen 0.68971,0.11197 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.06718 to screen 0.11207,0.06718 nohead lc rgb '#E69F00' dt 1 lw 1
set label '' at screen 0.09339,0.06718 point pt 13 ps 0.45 lc rgb '#E69F00'
set label 'Bernstein, smear sum' at screen 0.12069,0.06718 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.35922,0.06718 to screen 0.39658,0.06718 nohead lc rgb '#CC79A7' dt 1 lw 1
set label '' at screen 0.37790,0.06718 point pt 11 ps 0.45 lc rgb '#CC79A7'
set label 'Mourrain-Pavone, smear sum' at screen 0.40520,0.06718 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.64373,0.06718 to screen 0.68109,0.06718 nohead lc rgb '#56B4E9' dt 1 lw 1
set label '' at screen 0.66241,0.06718 point pt 6 ps 0.45 lc rgb '#56B4E9'
set label 'LP, smear sum' at screen 0.68971,0.06718 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.02239 to screen 0.11207,0.02239 nohead lc rgb '#000000' dt 1 lw 1
set label '' at screen 0.09339,0.02239 point pt 4 ps 0.45 lc rgb '#000000'
set label 'multipliers, smear sum' at screen 0.12069,0.02239 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.07471; set rmargin at screen 0.51437
set bmargin at screen 0.25255; set tmargin at screen 0.93780
set logscale x
set xrange [1:175.34907030865992]
set xtics ('1' 1, '2' 2, '5' 5, '10' 10, '20' 20, '50' 50, '100' 100)
unset logscale y
set yrange [0:102]
set ytics ('0' 0, '20' 20, '40' 40, '60' 60, '80' 80, '100' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:2 with steps lc rgb '#0072B2' dt 1 lw 1.4, \
  data index 0 using 1:2 every 15 with points pt 7 ps 0.45 lc rgb '#0072B2', \
  data index 1 using 1:2 with steps lc rgb '#D55E00' dt 1 lw 1.4, \
  data index 1 using 1:2 every 13 with points pt 5 ps 0.45 lc rgb '#D55E00', \
  data index 2 using 1:2 with steps lc rgb '#009E73' dt 1 lw 1.4, \
  data index 2 using 1:2 every 5 with points pt 9 ps 0.45 lc rgb '#009E73', \
  data index 3 using 1:2 with steps lc rgb '#E69F00' dt 1 lw 1.4, \
  data index 3 using 1:2 every 8 with points pt 13 ps 0.45 lc rgb '#E69F00', \
  data index 4 using 1:2 with steps lc rgb '#CC79A7' dt 1 lw 1.4, \
  data index 4 using 1:2 every 8 with points pt 11 ps 0.45 lc rgb '#CC79A7', \
  data index 5 using 1:2 with steps lc rgb '#56B4E9' dt 1 lw 1.4, \
  data index 5 using 1:2 every 13 with points pt 6 ps 0.45 lc rgb '#56B4E9', \
  data index 6 using 1:2 with steps lc rgb '#000000' dt 1 lw 1.4, \
  data index 6 using 1:2 every 13 with points pt 4 ps 0.45 lc rgb '#000000'
unset label; unset arrow

# boxes
set label 'boxes' at screen 0.54310,0.96517 left font ',8' tc rgb '#202020' noenhanced front
set label 'τ: boxes over the least of the methods' at screen 0.76293,0.17417 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.98276
set bmargin at screen 0.25255; set tmargin at screen 0.93780
set logscale x
set xrange [1:22880.399999999998]
set xtics ('1' 1, '10' 10, '100' 100, '1,000' 1000, '10,000' 10000)
unset logscale y
set yrange [0:102]
set ytics ('' 0, '' 20, '' 40, '' 60, '' 80, '' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 7 using 1:2 with steps lc rgb '#0072B2' dt 1 lw 1.4, \
  data index 7 using 1:2 every 15 with points pt 7 ps 0.45 lc rgb '#0072B2', \
  data index 8 using 1:2 with steps lc rgb '#D55E00' dt 1 lw 1.4, \
  data index 8 using 1:2 every 13 with points pt 5 ps 0.45 lc rgb '#D55E00', \
  data index 9 using 1:2 with steps lc rgb '#009E73' dt 1 lw 1.4, \
  data index 9 using 1:2 every 5 with points pt 9 ps 0.45 lc rgb '#009E73', \
  data index 10 using 1:2 with steps lc rgb '#E69F00' dt 1 lw 1.4, \
  data index 10 using 1:2 every 8 with points pt 13 ps 0.45 lc rgb '#E69F00', \
  data index 11 using 1:2 with steps lc rgb '#CC79A7' dt 1 lw 1.4, \
  data index 11 using 1:2 every 8 with points pt 11 ps 0.45 lc rgb '#CC79A7', \
  data index 12 using 1:2 with steps lc rgb '#56B4E9' dt 1 lw 1.4, \
  data index 12 using 1:2 every 13 with points pt 6 ps 0.45 lc rgb '#56B4E9', \
  data index 13 using 1:2 with steps lc rgb '#000000' dt 1 lw 1.4, \
  data index 13 using 1:2 every 13 with points pt 4 ps 0.45 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
