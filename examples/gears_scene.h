// SPDX-License-Identifier: MIT
//
// What the gears example draws. A context must be current.
#ifndef EXAMPLES_GEARS_SCENE_H
#define EXAMPLES_GEARS_SCENE_H

// Once, before the first frame.
void set_up_gears(int width, int height);
// When the surface has another size.
void set_gears_view(int width, int height);
// Clears the surface and draws the gears, which turn by a fixed angle each frame.
void draw_gears(int frame);

#endif
