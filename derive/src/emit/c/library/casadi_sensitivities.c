    {
        static const size_t places[@S] = {
            @PLACES
        };
        double sensitivities[@N * @S];
        int i, j;
        $_sensitivities(@POINT, sensitivities);
        for (j = 0; j < @S; ++j) {
            for (i = 0; i < @N; ++i) {
                columns[2 * @N * places[j] + @N + i] = sensitivities[i * @S + j];
            }
        }
    }
