#include "spline/curve.h"
