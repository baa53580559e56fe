# Natural and affine arithmetic on the quartic of Comba and Stolfi, variables halved in turn
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' covers.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 656,350 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.35cm,9.25cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'covers.'.format
data = 'covers.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 173.5 mm x 92 mm

# comba-stolfi / natural
set label 'natural' at screen 0.27089,0.97514 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 918 of 4,459 visited' at screen 0.27089,0.02432 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.04035; set rmargin at screen 0.50144
set bmargin at screen 0.08649; set tmargin at screen 0.95135
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y '%.3g'
set ytics (-2, 0, 2)
plot data index 0 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 1 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 2 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# comba-stolfi / affine
set label 'affine' at screen 0.75793,0.97514 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 282 of 1,479 visited' at screen 0.75793,0.02432 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.52738; set rmargin at screen 0.98847
set bmargin at screen 0.08649; set tmargin at screen 0.95135
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y ''
set ytics (-2, 0, 2)
plot data index 3 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 5 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
