BEGIN PGM BACK MM
CALL PGM programs-call-in-circle
END PGM BACK MM
