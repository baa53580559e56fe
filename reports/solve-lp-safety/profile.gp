# Performance profiles
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' profile.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,304 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,8.04cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'profile.'.format
data = 'profile.dat'
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
set label 'simplex safe dual' at screen 0.12069,0.11197 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.29451,0.11197 to screen 0.33186,0.11197 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.31318,0.11197 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'simplex exact' at screen 0.34048,0.11197 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.51430,0.11197 to screen 0.55166,0.11197 nohead lc rgb '#009E73' dt 1 lw 1
set label '' at screen 0.53298,0.11197 point pt 9 ps 0.45 lc rgb '#009E73'
set label 'simplex tolerance' at screen 0.56028,0.11197 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.06718 to screen 0.11207,0.06718 nohead lc rgb '#E69F00' dt 1 lw 1
set label '' at screen 0.09339,0.06718 point pt 13 ps 0.45 lc rgb '#E69F00'
set label 'simplex unprotected' at screen 0.12069,0.06718 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.29451,0.06718 to screen 0.33186,0.06718 nohead lc rgb '#CC79A7' dt 1 lw 1
set label '' at screen 0.31318,0.06718 point pt 11 ps 0.45 lc rgb '#CC79A7'
set label 'GLPK safe dual' at screen 0.34048,0.06718 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.51430,0.06718 to screen 0.55166,0.06718 nohead lc rgb '#56B4E9' dt 1 lw 1
set label '' at screen 0.53298,0.06718 point pt 6 ps 0.45 lc rgb '#56B4E9'
set label 'GLPK tolerance' at screen 0.56028,0.06718 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.07471,0.02239 to screen 0.11207,0.02239 nohead lc rgb '#000000' dt 1 lw 1
set label '' at screen 0.09339,0.02239 point pt 4 ps 0.45 lc rgb '#000000'
set label 'GLPK unprotected' at screen 0.12069,0.02239 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.29451,0.02239 to screen 0.33186,0.02239 nohead lc rgb '#0072B2' dt 2 lw 1
set label '' at screen 0.31318,0.02239 point pt 5 ps 0.45 lc rgb '#0072B2'
set label 'CLP safe dual' at screen 0.34048,0.02239 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.51430,0.02239 to screen 0.55166,0.02239 nohead lc rgb '#D55E00' dt 2 lw 1
set label '' at screen 0.53298,0.02239 point pt 9 ps 0.45 lc rgb '#D55E00'
set label 'CLP unprotected' at screen 0.56028,0.02239 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.07471; set rmargin at screen 0.51437
set bmargin at screen 0.25255; set tmargin at screen 0.93780
set logscale x
set xrange [1:406.0296053069532]
set xtics ('1' 1, '10' 10, '100' 100)
unset logscale y
set yrange [0:102]
set ytics ('0' 0, '20' 20, '40' 40, '60' 60, '80' 80, '100' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:2 with steps lc rgb '#0072B2' dt 1 lw 1.4, \
  data index 0 using 1:2 every 1 with points pt 7 ps 0.45 lc rgb '#0072B2', \
  data index 1 using 1:2 with steps lc rgb '#D55E00' dt 1 lw 1.4, \
  data index 1 using 1:2 every 1 with points pt 5 ps 0.45 lc rgb '#D55E00', \
  data index 2 using 1:2 with steps lc rgb '#009E73' dt 1 lw 1.4, \
  data index 2 using 1:2 every 1 with points pt 9 ps 0.45 lc rgb '#009E73', \
  data index 3 using 1:2 with steps lc rgb '#E69F00' dt 1 lw 1.4, \
  data index 3 using 1:2 every 1 with points pt 13 ps 0.45 lc rgb '#E69F00', \
  data index 4 using 1:2 with steps lc rgb '#CC79A7' dt 1 lw 1.4, \
  data index 4 using 1:2 every 1 with points pt 11 ps 0.45 lc rgb '#CC79A7', \
  data index 5 using 1:2 with steps lc rgb '#56B4E9' dt 1 lw 1.4, \
  data index 5 using 1:2 every 1 with points pt 6 ps 0.45 lc rgb '#56B4E9', \
  data index 6 using 1:2 with steps lc rgb '#000000' dt 1 lw 1.4, \
  data index 6 using 1:2 every 1 with points pt 4 ps 0.45 lc rgb '#000000', \
  data index 7 using 1:2 with steps lc rgb '#0072B2' dt 2 lw 1.4, \
  data index 7 using 1:2 every 1 with points pt 5 ps 0.45 lc rgb '#0072B2', \
  data index 8 using 1:2 with steps lc rgb '#D55E00' dt 2 lw 1.4, \
  data index 8 using 1:2 every 1 with points pt 9 ps 0.45 lc rgb '#D55E00'
unset label; unset arrow

# boxes
set label 'boxes' at screen 0.54310,0.96517 left font ',8' tc rgb '#202020' noenhanced front
set label 'τ: boxes over the least of the methods' at screen 0.76293,0.17417 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.98276
set bmargin at screen 0.25255; set tmargin at screen 0.93780
set logscale x
set xrange [1:10.597183098591549]
set xtics ('1' 1, '2' 2, '5' 5, '10' 10)
unset logscale y
set yrange [0:102]
set ytics ('' 0, '' 20, '' 40, '' 60, '' 80, '' 100)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 9 using 1:2 with steps lc rgb '#0072B2' dt 1 lw 1.4, \
  data index 9 using 1:2 every 1 with points pt 7 ps 0.45 lc rgb '#0072B2', \
  data index 10 using 1:2 with steps lc rgb '#D55E00' dt 1 lw 1.4, \
  data index 10 using 1:2 every 1 with points pt 5 ps 0.45 lc rgb '#D55E00', \
  data index 11 using 1:2 with steps lc rgb '#009E73' dt 1 lw 1.4, \
  data index 11 using 1:2 every 1 with points pt 9 ps 0.45 lc rgb '#009E73', \
  data index 12 using 1:2 with steps lc rgb '#E69F00' dt 1 lw 1.4, \
  data index 12 using 1:2 every 1 with points pt 13 ps 0.45 lc rgb '#E69F00', \
  data index 13 using 1:2 with steps lc rgb '#CC79A7' dt 1 lw 1.4, \
  data index 13 using 1:2 every 1 with points pt 11 ps 0.45 lc rgb '#CC79A7', \
  data index 14 using 1:2 with steps lc rgb '#56B4E9' dt 1 lw 1.4, \
  data index 14 using 1:2 every 1 with points pt 6 ps 0.45 lc rgb '#56B4E9', \
  data index 15 using 1:2 with steps lc rgb '#000000' dt 1 lw 1.4, \
  data index 15 using 1:2 every 1 with points pt 4 ps 0.45 lc rgb '#000000', \
  data index 16 using 1:2 with steps lc rgb '#0072B2' dt 2 lw 1.4, \
  data index 16 using 1:2 every 1 with points pt 5 ps 0.45 lc rgb '#0072B2', \
  data index 17 using 1:2 with steps lc rgb '#D55E00' dt 2 lw 1.4, \
  data index 17 using 1:2 every 1 with points pt 9 ps 0.45 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
