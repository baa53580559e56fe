# Sketches with the names of their parameters: lengths h, angles a
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.3.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 616,390 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 16.30cm,10.33cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.3.'.format
data = 'figure-4.3.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 163 mm x 103 mm
set label '6p7d3a2c' at screen 0.24847,0.97096 center font ',8' tc rgb '#202020' noenhanced front
set label 'pentahedron' at screen 0.75153,0.97096 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.24847,0.00678 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.01907,0.26921 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.36220,0.16081 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.47680,0.41264 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.13492,0.48276 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.36252,0.81015 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.36980,0.54124 center font ',7' tc rgb '#202020' noenhanced front
set label 'a1' at screen 0.19134,0.49699 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a2' at screen 0.16496,0.41488 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a3' at screen 0.09022,0.27741 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'h5' at screen 0.34342,0.65830 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.39739,0.31224 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.37002,0.35568 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8' at screen 0.42453,0.60998 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.19888,0.24864 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.18848,0.42211 center font ',7' tc rgb '#606060' noenhanced front
set label 'h9' at screen 0.24597,0.36364 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.02420; set tmargin at screen 0.94677
set xrange [-0.144259863:2.07961163]; set yrange [-0.722904553:1.92678261]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with lines lw 0.6 lc rgb '#D55E00', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 12 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2
set label '' at screen 0.75153,0.00678 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.51784,0.31332 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.98629,0.18092 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.91871,0.54496 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.92144,0.93027 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.75538,0.36861 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.67968,0.04071 center font ',7' tc rgb '#202020' noenhanced front
set label 'h8' at screen 0.83017,0.47007 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.71321,0.22898 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.61939,0.20515 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.95287,0.36346 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.89650,0.71752 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.82348,0.14517 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.82808,0.65109 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.76907,0.26525 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.71197,0.62820 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.02420; set tmargin at screen 0.94677
set xrange [-0.119954701:2.10391679]; set yrange [-0.830391902:1.81929527]
set border 0; unset xtics; unset ytics
plot data index 13 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 14 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 15 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 16 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 17 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 18 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 19 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 20 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 21 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 22 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 23 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 24 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
