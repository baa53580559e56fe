# Sketches of the hexahedron and of the flat problem with the same lengths
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.5.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 325,477 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.60cm,12.63cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.5.'.format
data = 'figure-3.5.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 86 mm x 126 mm
set label '' at screen 0.52907,0.97625 center font ',8' tc rgb '#202020' noenhanced front
set label 'hexahedron' at screen 0.02558,0.73993 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.52907,0.50914 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.09113,0.89737 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.28054,0.53688 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.49160,0.94295 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.27192,0.83894 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.97401,0.82993 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.62233,0.84158 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.23969,0.76975 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.85755,0.66742 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06395; set rmargin at screen 0.99419
set bmargin at screen 0.52339; set tmargin at screen 0.95646
set xrange [-0.101655127:1.78295577]; set yrange [-1.06630917:0.222451003]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
set label 'hexahedron-flat' at screen 0.02558,0.26367 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 2, column 1
set label '' at screen 0.52907,0.00554 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.57831,0.03330 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.97401,0.35388 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.46871,0.49405 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.08613,0.26680 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.46358,0.36381 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.31887,0.25692 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.48607,0.17068 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.75257,0.29401 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06395; set rmargin at screen 0.99419
set bmargin at screen 0.01979; set tmargin at screen 0.50756
set xrange [-1.87267553:1.56183977]; set yrange [-0.171725765:2.47355491]
set border 0; unset xtics; unset ytics
plot data index 10 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 11 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 12 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 13 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 14 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 20 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
