# Sorvaustyökiertojen kuvien otsikot.

figure-turning-roughing = Rouhinta
figure-turning-finishing = Silitys
figure-turning-inside = Sisäpuoli
figure-turning-system = Koordinaatisto
figure-turning-reversed-tool = Käännetty työkalu
figure-turning-smoothing = Muodon tasoitus
figure-turning-start-element = Elementti alussa
figure-turning-end-element = Elementti lopussa
figure-turning-elements = Viiste, pyöristys ja nurkan säde
figure-turning-angles = Kulmat
figure-turning-limit = Lastuamisraja
figure-turning-reversal = Muodon suunta
figure-turning-undercut = Sisäänpisto
figure-turning-cutting-lines = Lastuamisradat
figure-turned-thread = Kierre
figure-thread-position = Kierteen sijainti
figure-thread-orientation = Kierteen suunta
figure-turning-infeed = Asetusliike
figure-turning-infeed-type = Asetustapa
figure-turning-depth = Syvyys ja ulosajo
figure-recess-offset = Siirtymäleveys
figure-recess-compensation = Syvyyskorjaus
figure-recess-direction = Koneistussuunta
figure-text-on-arc = Teksti kaarella
figure-text-arrangement = Tekstin asettelu
figure-around-cylinder = Lieriön ympäri
