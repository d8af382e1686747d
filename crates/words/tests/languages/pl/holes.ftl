reaches-again = znowu klasa { $it }, { $roughness }
