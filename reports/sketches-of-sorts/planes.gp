# The planes that touch three spheres, which differ by the spheres on one side
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' planes.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 616,675 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 16.30cm,17.86cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'planes.'.format
data = 'planes.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 163 mm x 179 mm
set label 'plane-touching-spheres' at screen 0.50000,0.98320 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 16 solutions
set label '16 solutions' at screen 0.24847,0.52283 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.18349,0.82566 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.14473,0.67902 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.38657,0.68054 center font ',7' tc rgb '#202020' noenhanced front
set label 'p' at screen 0.03915,0.81250 center font ',7' tc rgb '#9A6A00' noenhanced front
set label 'u' at screen 0.21438,0.81462 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'v' at screen 0.18310,0.68675 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'w' at screen 0.42046,0.68479 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.53291; set tmargin at screen 0.96920
set xrange [-5.02332601:8.38274208]; set yrange [-8.40598397:4.65061358]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 2 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 3 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 4 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 5 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 6 using 1:2 with lines lw 0.66 lc rgb '#99C7E0', \
  data index 7 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 8 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 9 using 1:2 with lines lw 0.748 lc rgb '#7AB6D7', \
  data index 10 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 11 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 12 using 1:2 with lines lw 0.924 lc rgb '#3D94C4', \
  data index 13 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 14 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 15 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 16 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5'
unset label; unset arrow

# line 1, column 2, 16 solutions
set label '16 solutions' at screen 0.75153,0.52283 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.66714,0.86348 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.62838,0.71684 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.87022,0.71836 center font ',7' tc rgb '#202020' noenhanced front
set label 'p' at screen 0.86182,0.56333 center font ',7' tc rgb '#9A6A00' noenhanced front
set label 'u' at screen 0.69803,0.85244 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'v' at screen 0.66674,0.72457 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'w' at screen 0.90411,0.72261 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.53291; set tmargin at screen 0.96920
set xrange [-4.49283599:8.91323211]; set yrange [-9.53793295:3.5186646]
set border 0; unset xtics; unset ytics
plot data index 18 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 19 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 20 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 21 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 22 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 23 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 24 using 1:2 with lines lw 0.66 lc rgb '#99C7E0', \
  data index 25 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 26 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 27 using 1:2 with lines lw 0.748 lc rgb '#7AB6D7', \
  data index 28 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 29 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 30 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 31 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 32 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 33 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 34 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 35 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 36 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 37 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 38 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5'
unset label; unset arrow

# line 2, column 1, 16 solutions
set label '16 solutions' at screen 0.24847,0.02408 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.19166,0.36373 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.15290,0.21709 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.39474,0.21860 center font ',7' tc rgb '#202020' noenhanced front
set label 'p' at screen 0.03977,0.29381 center font ',7' tc rgb '#9A6A00' noenhanced front
set label 'u' at screen 0.22255,0.35269 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'v' at screen 0.19127,0.22481 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'w' at screen 0.42863,0.22286 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.03416; set tmargin at screen 0.50155
set xrange [-5.24648896:8.15957914]; set yrange [-9.5078825:4.47952353]
set border 0; unset xtics; unset ytics
plot data index 39 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 40 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 41 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 42 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 43 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 44 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 45 using 1:2 with lines lw 0.66 lc rgb '#99C7E0', \
  data index 46 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 47 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 48 using 1:2 with lines lw 0.748 lc rgb '#7AB6D7', \
  data index 49 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 50 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 51 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 52 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 53 using 1:2 with lines lw 0.924 lc rgb '#3D94C4', \
  data index 54 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 55 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 56 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 57 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 58 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5'
unset label; unset arrow

# line 2, column 2, 16 solutions
set label '16 solutions' at screen 0.75153,0.02408 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.68513,0.36750 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.64637,0.22086 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.88821,0.22238 center font ',7' tc rgb '#202020' noenhanced front
set label 'p' at screen 0.69310,0.07506 center font ',7' tc rgb '#9A6A00' noenhanced front
set label 'u' at screen 0.71602,0.35646 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'v' at screen 0.68474,0.22859 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'w' at screen 0.92210,0.22663 center font ',7' tc rgb '#0072B2' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.03416; set tmargin at screen 0.50155
set xrange [-4.98435154:8.42171656]; set yrange [-9.62086135:4.36654469]
set border 0; unset xtics; unset ytics
plot data index 59 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 60 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 61 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 62 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 63 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 64 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 65 using 1:2 with lines lw 0.66 lc rgb '#99C7E0', \
  data index 66 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 67 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 68 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 69 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 70 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 71 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 72 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 73 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 74 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 75 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 76 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 77 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 78 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 79 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 80 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5'
unset label; unset arrow
unset multiplot
unset output
