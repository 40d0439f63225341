# Titles of figures of turning cycles.

figure-turning-roughing = Roughing
figure-turning-finishing = Finishing
figure-turning-inside = Inside
figure-turning-system = Coordinate system
figure-turning-reversed-tool = Reversed tool
figure-turning-smoothing = Contour smoothing
figure-turning-start-element = Element at the beginning
figure-turning-end-element = Element at the end
figure-turning-elements = Chamfer, rounding and corner radius
figure-turning-angles = Angles
figure-turning-limit = Cutting limit
figure-turning-reversal = Direction of the contour
figure-turning-undercut = Plunging
figure-turning-cutting-lines = Cutting lines
figure-turned-thread = Thread
figure-thread-position = Outside or inside
figure-thread-orientation = Longitudinal or transverse
figure-turning-infeed = Infeed
figure-turning-infeed-type = Type of infeed
figure-turning-depth = Depth and run-out
figure-recess-offset = Offset width
figure-recess-compensation = Depth compensation
figure-recess-direction = Machining direction
figure-text-on-arc = Text on an arc
figure-text-arrangement = Text on a line or on an arc
figure-around-cylinder = Around the cylinder
