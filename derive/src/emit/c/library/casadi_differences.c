    {
        /* Central differences. */
        static const size_t places[@D] = {
            @PLACES
        };
        int i, j;
        for (j = 0; j < @D; ++j) {
            double *const number = at.p + places[j];
            const double at_center = *number, h = cbrt(DBL_EPSILON) * (at_center == 0.0 ? 1.0 : fabs(at_center));
            const double least = at_center - h, most = at_center + h;
            double below[@N], above[@N];
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
