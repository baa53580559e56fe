# The random sketch of three spheres and a plane, and figures along its path
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' deformation.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,310 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,8.20cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'deformation.'.format
data = 'deformation.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 82 mm

# line 1, column 1, t = 0.00
set label 't = 0.00' at screen 0.12284,0.53730 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.55924; set tmargin at screen 0.99391
set xrange [-7.04033616:7.88189017]; set yrange [-7.30072196:5.44501786]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 2 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 3 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 4 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 5 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 6 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 7 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 8 using 1:2 with lines lw 0.836 lc rgb '#5CA5CE', \
  data index 9 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 10 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 11 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 12 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 13 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 14 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, t = 0.98
set label 't = 0.98' at screen 0.37428,0.53730 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.55924; set tmargin at screen 0.99391
set xrange [-5.38379192:9.53843441]; set yrange [-8.20133674:4.54440308]
set border 0; unset xtics; unset ytics
plot data index 20 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 21 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 22 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 23 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 24 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 25 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 26 using 1:2 with lines lw 0.66 lc rgb '#99C7E0', \
  data index 27 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 28 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 29 using 1:2 with lines lw 0.748 lc rgb '#7AB6D7', \
  data index 30 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 31 using 1:2 with lines lw 0.836 lc rgb '#5CA5CE', \
  data index 32 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 33 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 34 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 35 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 36 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 37 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5'
unset label; unset arrow

# line 1, column 3, t = 0.27
set label 't = 0.27' at screen 0.62572,0.53730 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.55924; set tmargin at screen 0.99391
set xrange [-5.01370664:9.90851969]; set yrange [-7.9942444:4.75149543]
set border 0; unset xtics; unset ytics
plot data index 38 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 39 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 40 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 41 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 42 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 43 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 44 using 1:2 with lines lw 0.699 lc rgb '#9AA8B5', \
  data index 45 using 1:2 with lines lw 0.747 lc rgb '#7AB6D7', \
  data index 46 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 47 using 1:2 with lines lw 0.849 lc rgb '#7A8C9C', \
  data index 48 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 49 using 1:2 with lines lw 0.999 lc rgb '#5A7083', \
  data index 50 using 1:2 with lines lw 0.923 lc rgb '#3D94C4', \
  data index 51 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 52 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 53 using 1:2 with lines lw 0.735 lc rgb '#E9AB1F', \
  data index 54 using 1:2 with lines lw 0.799 lc rgb '#E69F00', \
  data index 55 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 56 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B'
unset label; unset arrow

# line 1, column 4, t = −0.33
set label 't = −0.33' at screen 0.87716,0.53730 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.55924; set tmargin at screen 0.99391
set xrange [-8.12953832:6.79268801]; set yrange [-7.58467982:5.16106001]
set border 0; unset xtics; unset ytics
plot data index 57 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 58 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 59 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 60 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 61 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 62 using 1:2 with lines lw 0.66 lc rgb '#99C7E0', \
  data index 63 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 64 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 65 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 66 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 67 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 68 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 69 using 1:2 with lines lw 0.924 lc rgb '#3D94C4', \
  data index 70 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 71 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 72 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 73 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 74 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 75 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 76 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 77 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B'
unset label; unset arrow

# line 2, column 1, t = 0.48
set label 't = 0.48' at screen 0.12284,0.05241 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.07435; set tmargin at screen 0.49098
set xrange [-10.7467421:4.17548419]; set yrange [-7.78723585:4.42968304]
set border 0; unset xtics; unset ytics
plot data index 78 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 79 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 80 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 81 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 82 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 83 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 84 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 85 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 86 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 87 using 1:2 with lines lw 0.836 lc rgb '#5CA5CE', \
  data index 88 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 89 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 90 using 1:2 with lines lw 0.924 lc rgb '#3D94C4', \
  data index 91 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 92 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 93 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 94 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 95 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 96 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B'
unset label; unset arrow

# line 2, column 2, t = 0.79
set label 't = 0.79' at screen 0.37428,0.05241 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.07435; set tmargin at screen 0.49098
set xrange [-10.2897999:4.63242639]; set yrange [-9.29277842:2.92414047]
set border 0; unset xtics; unset ytics
plot data index 97 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 98 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 99 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 100 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 101 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 102 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 103 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 104 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 105 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 106 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 107 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 108 using 1:2 with lines lw 0.924 lc rgb '#3D94C4', \
  data index 109 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 110 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 111 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 112 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 113 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 114 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 115 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 116 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 117 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 118 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 3, t = −0.25
set label 't = −0.25' at screen 0.62572,0.05241 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.07435; set tmargin at screen 0.49098
set xrange [-10.4429639:4.47926245]; set yrange [-6.23890404:5.97801484]
set border 0; unset xtics; unset ytics
plot data index 119 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 120 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 121 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 122 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 123 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 124 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 125 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 126 using 1:2 with lines lw 0.748 lc rgb '#7AB6D7', \
  data index 127 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 128 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 129 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 130 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 131 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 132 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 133 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 134 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 135 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 136 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 137 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 138 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 4, t = 0.00
set label 't = 0.00' at screen 0.87716,0.05241 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.07435; set tmargin at screen 0.49098
set xrange [-7.04033616:7.88189017]; set yrange [-7.03631149:5.18060739]
set border 0; unset xtics; unset ytics
plot data index 139 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 140 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#E69F00', \
  data index 141 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 142 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 143 using 1:2 with lines lw 0.5 lc rgb '#56B4E9', \
  data index 144 using 1:2 with lines lw 0.48 lc rgb '#F5D999', \
  data index 145 using 1:2 with lines lw 0.544 lc rgb '#F2CD7A', \
  data index 146 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 147 using 1:2 with lines lw 0.836 lc rgb '#5CA5CE', \
  data index 148 using 1:2 with lines lw 0.608 lc rgb '#EFC25C', \
  data index 149 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 150 using 1:2 with lines lw 0.672 lc rgb '#ECB63D', \
  data index 151 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 152 using 1:2 with lines lw 1.01 lc rgb '#1F83BB', \
  data index 153 using 1:2 with lines lw 0.736 lc rgb '#E9AB1F', \
  data index 154 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 155 using 1:2 with lines lw 0.8 lc rgb '#E69F00', \
  data index 156 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 157 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 158 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
