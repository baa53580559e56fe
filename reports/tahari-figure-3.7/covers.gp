# Random curves of degree 10, 14 and 18: natural intervals, Taubin's form, Bernstein - de Casteljau
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' covers.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,694 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,18.35cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'covers.'.format
data = 'covers.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 184 mm

# random-10 / natural
set label 'random-10' at screen 0.01149,0.83833 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label 'natural' at screen 0.21360,0.98747 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 2,560 of 8,105 visited' at screen 0.21360,0.66985 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.35824
set bmargin at screen 0.70118; set tmargin at screen 0.97548
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y '%.3g'
set ytics (-1, 0, 1)
plot data index 0 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 1 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 2 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-10 / taubin
set label 'taubin' at screen 0.52874,0.98747 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 268 of 1,381 visited' at screen 0.52874,0.66985 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.38410; set rmargin at screen 0.67337
set bmargin at screen 0.70118; set tmargin at screen 0.97548
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 3 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 5 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-10 / bernstein
set label 'bernstein' at screen 0.84387,0.98747 center font ',8' tc rgb '#202020' noenhanced front
set label 'kept 260 of 1,053 visited' at screen 0.84387,0.66985 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.69923; set rmargin at screen 0.98851
set bmargin at screen 0.70118; set tmargin at screen 0.97548
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 6 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 7 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 8 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-14 / natural
set label 'random-14' at screen 0.01149,0.50954 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label 'kept 3,162 of 11,665 visited' at screen 0.21360,0.34105 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.35824
set bmargin at screen 0.37239; set tmargin at screen 0.64668
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y '%.3g'
set ytics (-1, 0, 1)
plot data index 9 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 10 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 11 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-14 / taubin
set label 'kept 388 of 1,937 visited' at screen 0.52874,0.34105 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.38410; set rmargin at screen 0.67337
set bmargin at screen 0.37239; set tmargin at screen 0.64668
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 12 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 13 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 14 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-14 / bernstein
set label 'kept 368 of 1,429 visited' at screen 0.84387,0.34105 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.69923; set rmargin at screen 0.98851
set bmargin at screen 0.37239; set tmargin at screen 0.64668
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 15 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 16 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 17 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-18 / natural
set label 'random-18' at screen 0.01149,0.18074 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label 'kept 5,519 of 16,489 visited' at screen 0.21360,0.01226 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.35824
set bmargin at screen 0.04360; set tmargin at screen 0.31789
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y '%.3g'
set ytics (-1, 0, 1)
plot data index 18 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 19 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 20 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-18 / taubin
set label 'kept 469 of 2,469 visited' at screen 0.52874,0.01226 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.38410; set rmargin at screen 0.67337
set bmargin at screen 0.04360; set tmargin at screen 0.31789
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 21 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 22 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 23 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow

# random-18 / bernstein
set label 'kept 432 of 1,721 visited' at screen 0.84387,0.01226 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.69923; set rmargin at screen 0.98851
set bmargin at screen 0.04360; set tmargin at screen 0.31789
set xrange [-1:1]
set format x '%.3g'
set xtics (-1, 0, 1)
set yrange [-1:1]
set format y ''
set ytics (-1, 0, 1)
plot data index 24 using 1:2 with lines lw 0.2 lc rgb '#C4C4C4', \
  data index 25 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E69F00', \
  data index 26 using 1:2 with lines lw 0.2 lc rgb '#000000'
unset label; unset arrow
unset multiplot
unset output
