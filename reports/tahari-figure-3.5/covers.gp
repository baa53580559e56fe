# Cassini oval, eight levels: natural intervals, Taubin's form, Bernstein - de Casteljau
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' covers.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,244 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,6.45cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'covers.'.format
data = 'covers.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 64 mm

# cassini-2-2 / natural
set label 'natural' at screen 0.18966,0.96434 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 2,180 of 7,141 visited' at screen 0.18966,0.03488 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.04023; set rmargin at screen 0.33908
set bmargin at screen 0.12403; set tmargin at screen 0.93023
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

# cassini-2-2 / taubin
set label 'taubin' at screen 0.51437,0.96434 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 820 of 3,525 visited' at screen 0.51437,0.03488 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.36494; set rmargin at screen 0.66379
set bmargin at screen 0.12403; set tmargin at screen 0.93023
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

# cassini-2-2 / bernstein
set label 'bernstein' at screen 0.83908,0.96434 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 772 of 3,045 visited' at screen 0.83908,0.03488 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.68966; set rmargin at screen 0.98851
set bmargin at screen 0.12403; set tmargin at screen 0.93023
set xrange [-2:2]
set format x '%.3g'
set xtics (-2, 0, 2)
set yrange [-2:2]
set format y ''
set ytics (-2, 0, 2)
plot data index 6 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 7 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 8 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
