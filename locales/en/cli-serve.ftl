# The command “serve”.
cli-serve = Show the manuals and the state of the translations in a browser on this machine
cli-serve-port = Port to listen on (default: 8477); 0 takes any that is free
cli-serve-address = The manuals are at { $address }; Ctrl+C ends.
cli-serve-anew = The data have changed: { $files ->
        [0] the pages cannot be made.
       *[other] { $files } files made anew.
    }
cli-examples-serve =
    ciklo serve
    ciklo --data . serve --control tnc640 --lang fi
diag-serve-address = { $path } cannot be used as an address: { $reason ->
        [in-use] another program uses the port; choose another one with --port
        [permission] permission is denied; choose a port above 1023 with --port
       *[other] { $detail }
    }.
explain-serve-address = “ciklo serve” listens on a port of this machine, where only this machine reaches it. A port can be used by one program at a time, and ports up to 1023 are often reserved for the system. Example: ciklo serve, while another one is running in a second window. End the other program, or choose another port with --port; with --port 0 the system gives one that is free.
