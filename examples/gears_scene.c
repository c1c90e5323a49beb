// SPDX-License-Identifier: MIT
//
// Three meshing spur gears and a light: the scene of the gears example, which the bench measures
// too.

#include "gears_scene.h"

#include "gear.h"

static Gear gears[3] = {
    {.teeth = 24,
     .width = 1.2f,
     .web_width = 0.5f,
     .bore = 0.9f,
     .hub = 1.7f,
     .colour = {0.80f, 0.10f, 0.06f, 1.0f},
     .x = -2.6f,
     .y = -1.6f,
     .speed = 1.0f},
    {.teeth = 12,
     .width = 2.0f,
     .web_width = 1.4f,
     .bore = 0.45f,
     .hub = 0.85f,
     .colour = {0.05f, 0.65f, 0.16f, 1.0f}},
    {.teeth = 16,
     .width = 0.9f,
     .web_width = 0.4f,
     .bore = 1.1f,
     .hub = 1.5f,
     .colour = {0.12f, 0.25f, 0.90f, 1.0f}},
};

void set_gears_view(int width, int height) {
  const float aspect = (float)height / (float)width;
  const float half = aspect < 0.75f ? 0.75f / aspect : 1.0f;  // the gears fit a frame of 4:3
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustumf(-half, half, -half * aspect, half * aspect, 5.0f, 80.0f);
  glMatrixMode(GL_MODELVIEW);
}

void set_up_gears(int width, int height) {
  static const float light_position[4] = {-14.0f, 13.0f, -26.0f, 1.0f};
  static const float ambient[4] = {0.22f, 0.22f, 0.24f, 1.0f};
  static const float diffuse[4] = {0.95f, 0.95f, 0.92f, 1.0f};
  static const float white[4] = {1.0f, 1.0f, 1.0f, 1.0f};
  mesh_with(&gears[1], &gears[0], -15.0f * kPi / 180.0f);
  mesh_with(&gears[2], &gears[0], 52.0f * kPi / 180.0f);
  for (int i = 0; i < 3; ++i) build_gear(&gears[i]);

  set_gears_view(width, height);
  glLoadIdentity();
  glLightfv(GL_LIGHT0, GL_POSITION, light_position);
  glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
  glLightfv(GL_LIGHT0, GL_SPECULAR, white);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glClearColor(0.09f, 0.10f, 0.12f, 1.0f);
}

void draw_gears(int frame) {
  static const float shine[4] = {0.55f, 0.55f, 0.55f, 1.0f};
  const float turned = 1.5f * (float)frame;  // degrees of gear 0
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glPushMatrix();
  glTranslatef(0.2f, -0.5f, -56.0f);
  glRotatef(22.0f, 1.0f, 0.0f, 0.0f);
  glRotatef(28.0f, 0.0f, 1.0f, 0.0f);
  for (int i = 0; i < 3; ++i) {
    const Gear* gear = &gears[i];
    glPushMatrix();
    glTranslatef(gear->x, gear->y, 0.0f);
    glRotatef(gear->phase * 180.0f / kPi + gear->speed * turned, 0.0f, 0.0f, 1.0f);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, gear->colour);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 18.0f);
    draw_gear(gear);
    glPopMatrix();
  }
  glPopMatrix();
}
