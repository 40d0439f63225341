# Parametri ciklov za poševni položaj in referenčne točke: ime, oznaka v NC-stavku, pomoč.

# --- referenčne točke: kar se razlikuje od izvrtine ---
parameter-new-datum-probe-axis__datum-inside-rectangle = Nova referenčna točka
