# Performance profiles of arithmetics
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' profile.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,317 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,8.38cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'profile.'.format
data = 'profile.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 84 mm

# CPU time
set label 'τ: CPU time over the least of the methods' at screen 0.52874,0.16706 center font ',7' tc rgb '#202020' noenhanced front
set label 'problems solved within τ [%]' at screen 0.01149,0.61217 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.03375,0.10740 to screen 0.07110,0.10740 nohead lc rgb '#0072B2' dt 1 lw 1
set label '' at screen 0.05243,0.10740 point pt 7 ps 0.45 lc rgb '#0072B2'
set label 'hull+multipliers, fast' at screen 0.07972,0.10740 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.35870,0.10740 to screen 0.39606,0.10740 nohead lc rgb '#D55E00' dt 1 lw 1
set label '' at screen 0.37738,0.10740 point pt 5 ps 0.45 lc rgb '#D55E00'
set label 'hull+newton, fast' at screen 0.40468,0.10740 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.68366,0.10740 to screen 0.72102,0.10740 nohead lc rgb '#009E73' dt 1 lw 1
set label '' at screen 0.70234,0.10740 point pt 9 ps 0.45 lc rgb '#009E73'
set label 'hull+multipliers, Boost' at screen 0.72964,0.10740 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.03375,0.06444 to screen 0.07110,0.06444 nohead lc rgb '#E69F00' dt 1 lw 1
set label '' at screen 0.05243,0.06444 point pt 13 ps 0.45 lc rgb '#E69F00'
set label 'hull+newton, Boost' at screen 0.07972,0.06444 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.35870,0.06444 to screen 0.39606,0.06444 nohead lc rgb '#CC79A7' dt 1 lw 1
set label '' at screen 0.37738,0.06444 point pt 11 ps 0.45 lc rgb '#CC79A7'
set label 'hull+multipliers, MPFR, 128 bits' at screen 0.40468,0.06444 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.68366,0.06444 to screen 0.72102,0.06444 nohead lc rgb '#56B4E9' dt 1 lw 1
set label '' at screen 0.70234,0.06444 point pt 6 ps 0.45 lc rgb '#56B4E9'
set label 'hull+newton, MPFR, 128 bits' at screen 0.72964,0.06444 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.03375,0.02148 to screen 0.07110,0.02148 nohead lc rgb '#000000' dt 1 lw 1
set label '' at screen 0.05243,0.02148 point pt 4 ps 0.45 lc rgb '#000000'
set label 'hull+multipliers, unrounded' at screen 0.07972,0.02148 left font ',7' tc rgb '#202020' noenhanced front
set arrow from screen 0.35870,0.02148 to screen 0.39606,0.02148 nohead lc rgb '#0072B2' dt 2 lw 1
set label '' at screen 0.37738,0.02148 point pt 5 ps 0.45 lc rgb '#0072B2'
set label 'hull+newton, unrounded' at screen 0.40468,0.02148 left font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.07471; set rmargin at screen 0.98276
set bmargin at screen 0.24224; set tmargin at screen 0.98210
set logscale x
set xrange [1:834.6293647199999]
set xtics ('1' 1, '10' 10, '100' 100)
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
  data index 5 using 1:2 every 2 with points pt 6 ps 0.45 lc rgb '#56B4E9', \
  data index 6 using 1:2 with steps lc rgb '#000000' dt 1 lw 1.4, \
  data index 6 using 1:2 every 1 with points pt 4 ps 0.45 lc rgb '#000000', \
  data index 7 using 1:2 with steps lc rgb '#0072B2' dt 2 lw 1.4, \
  data index 7 using 1:2 every 1 with points pt 5 ps 0.45 lc rgb '#0072B2'
unset label; unset arrow
unset multiplot
unset output
