    {
        /* Central differences, with steps in proportion to a number, or to the largest one of its array if that is much larger. */
        static const size_t places[@D] = {
            @PLACES
        };
        static const int arrays[@D] = {
            @ARRAYS
        };
        int i, j;
        for (j = 0; j < @D; ++j) {
            double *const number = at.p + places[j];
            const double at_center = *number;
            double below[@N], above[@N], size = fabs(at_center), least, most;
            for (i = 0; i < @D; ++i) {
                if (arrays[i] == arrays[j]) {
                    size = fmax(size, 1e-2 * fabs(at.p[places[i]]));
                }
            }
            size = cbrt(DBL_EPSILON) * (size == 0.0 ? 1.0 : size);
            least = at_center - size;
            most = at_center + size;
            *number = least;
            $_accelerations(@POINT, below@MULTIPLIERS);
            *number = most;
            $_accelerations(@POINT, above@MULTIPLIERS);
            *number = at_center;
            for (i = 0; i < @N; ++i) {
                columns[2 * @N * places[j] + @N + i] = (above[i] - below[i]) / (most - least);
            }
        }
    }
