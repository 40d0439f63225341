# Tables that cycles read or write.
table-tool = Tool table
table-preset = Preset table
table-datum = Datum table
table-probe = Touch probe table
table-kinematics = Kinematics table
