# Time of one reduction, and memory of the process that does it
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' growth.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,274 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,7.25cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'growth.'.format
data = 'growth.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 73 mm

# CPU time
set label 'CPU time [µs]' at screen 0.05875,0.96139 left font ',8' tc rgb '#202020' noenhanced front
set label 'unknowns' at screen 0.27794,0.08687 center font ',7' tc rgb '#202020' noenhanced front
set label 'CPU time [µs]' at screen 0.01149,0.55240 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.05875,0.02482 to screen 0.09611,0.02482 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.07743,0.02482 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'tensor Bernstein' at screen 0.10473,0.02482 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.27046,0.02482 to screen 0.30781,0.02482 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.28913,0.02482 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'LP on the polytope' at screen 0.31643,0.02482 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.48216,0.02482 to screen 0.51952,0.02482 nohead lc rgb '#009E73' dt 1 lw 1
set label '' at screen 0.50084,0.02482 point pt 9 ps 0.45 lc rgb '#009E73'
set label 'multipliers' at screen 0.52814,0.02482 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.05875; set rmargin at screen 0.49713
set bmargin at screen 0.17375; set tmargin at screen 0.93105
unset logscale x
set xrange [0.26:61.74]
set xtics ('20' 20, '40' 40, '60' 60)
set logscale y
set yrange [0.5677441415563262:3027551.8079999997]
set ytics ('10⁰' 1, '10¹' 10, '10²' 100, '10³' 1000, '10⁴' 10000, '10⁵' 100000, '10⁶' 1e+06)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 0 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#0072B2', \
  data index 1 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#D55E00', \
  data index 2 using 1:3:(0):($4-$3) with vectors nohead lw 0.6 lc rgb '#009E73', \
  data index 0 using 1:2 with linespoints pt 7 ps 0.45 lc rgb '#0072B2' dt 1 lw 1, \
  data index 1 using 1:2 with linespoints pt 5 ps 0.45 lc rgb '#D55E00' dt 1 lw 1, \
  data index 2 using 1:2 with linespoints pt 9 ps 0.45 lc rgb '#009E73' dt 1 lw 1
unset label; unset arrow

# peak memory
set label 'peak memory [MB]' at screen 0.54438,0.96139 left font ',8' tc rgb '#202020' noenhanced front
set label 'unknowns' at screen 0.76357,0.08687 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54438; set rmargin at screen 0.98276
set bmargin at screen 0.17375; set tmargin at screen 0.93105
unset logscale x
set xrange [0.26:61.74]
set xtics ('20' 20, '40' 40, '60' 60)
set logscale y
set yrange [10.427733333333334:842.8044288]
set ytics ('20' 20, '50' 50, '100' 100, '200' 200, '500' 500)
set grid ytics lt 1 lw 0.3 lc rgb '#DDDDDD'
set border 3
plot \
  data index 3 using 1:2 with linespoints pt 7 ps 0.45 lc rgb '#0072B2' dt 1 lw 1, \
  data index 4 using 1:2 with linespoints pt 5 ps 0.45 lc rgb '#D55E00' dt 1 lw 1, \
  data index 5 using 1:2 with linespoints pt 9 ps 0.45 lc rgb '#009E73' dt 1 lw 1
unset label; unset arrow
unset multiplot
unset output
