/* A program of SDL2 in a window of OpenGL ES 1.1: sprites, points, lines, rectangles, all blend
 * modes, rotated and mirrored copies, render targets. It draws its picture twice, with SDL's
 * `software` renderer in memory and with what SDL's `opengles` renderer calls (Debian builds SDL2
 * without that one), reads the window back and compares.
 *
 * The tolerances: a component may differ by 4/255 (SDL rounds blended colours down, and twice where
 * a sprite has a colour and an alpha of its own), in no pixel more. SDL's software renderer rotates
 * in steps of whole texels, up to half a texel from their place: in the part with rotated copies
 * the means of blocks of 8x8 pixels are compared, and may differ by 24/255.
 *
 * Prints what it ran on and how far the pictures are apart; fails if that is too far. With a file
 * name it writes both pictures there, side by side (BMP).
 *
 * SPDX-License-Identifier: MIT */
#include <GLES/gl.h>
#include <GLES/glext.h>
#include <SDL2/SDL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kSize = 256, kSprite = 32, kTarget = 64, kTolerance = 4, kRotatedTop = 192 };
enum { kBlock = 8, kBlockTolerance = 24 };

static void die(const char* what) {
  fprintf(stderr, "sdl_sprites: %s: %s\n", what, SDL_GetError());
  exit(1);
}

typedef struct {
  SDL_BlendMode blend;
  SDL_Color colour; /* of what has no texture, or what modulates the texture */
} Paint;

/* An image of either renderer. */
typedef struct {
  int width, height;
  SDL_Texture* software;
  GLuint name, framebuffer;
} Image;

/* What draws: the two renderers. */
typedef struct {
  void (*clear)(SDL_Color colour);
  void (*points)(Paint paint, const SDL_Point* points, int count);
  void (*line)(Paint paint, SDL_Point from, SDL_Point to);
  void (*fill)(Paint paint, SDL_Rect rect);
  void (*copy)(Paint paint, Image* image, SDL_Rect from, SDL_Rect to, double angle,
               SDL_RendererFlip flip);
  void (*set_target)(Image* image); /* NULL: the window */
} Painter;

/* SDL's own. */

static SDL_Renderer* software;

static void software_paint(Paint p) {
  SDL_SetRenderDrawBlendMode(software, p.blend);
  SDL_SetRenderDrawColor(software, p.colour.r, p.colour.g, p.colour.b, p.colour.a);
}
static void software_clear(SDL_Color c) {
  SDL_SetRenderDrawColor(software, c.r, c.g, c.b, c.a);
  SDL_RenderClear(software);
}
static void software_points(Paint p, const SDL_Point* points, int count) {
  software_paint(p);
  SDL_RenderDrawPoints(software, points, count);
}
static void software_line(Paint p, SDL_Point from, SDL_Point to) {
  software_paint(p);
  SDL_RenderDrawLine(software, from.x, from.y, to.x, to.y);
}
static void software_fill(Paint p, SDL_Rect rect) {
  software_paint(p);
  SDL_RenderFillRect(software, &rect);
}
static void software_copy(Paint p, Image* image, SDL_Rect from, SDL_Rect to, double angle,
                          SDL_RendererFlip flip) {
  SDL_SetTextureBlendMode(image->software, p.blend);
  SDL_SetTextureColorMod(image->software, p.colour.r, p.colour.g, p.colour.b);
  SDL_SetTextureAlphaMod(image->software, p.colour.a);
  if (SDL_RenderCopyEx(software, image->software, &from, &to, angle, NULL, flip)) die("copy");
}
static void software_set_target(Image* image) {
  if (SDL_SetRenderTarget(software, image ? image->software : NULL)) die("render target");
}

static const Painter kSoftware = {software_clear, software_points, software_line,
                                  software_fill,  software_copy,   software_set_target};

/* OpenGL ES 1.1, as SDL's driver does it. */

static PFNGLBLENDFUNCSEPARATEOESPROC blend_func_separate;
static PFNGLGENFRAMEBUFFERSOESPROC gen_framebuffers;
static PFNGLBINDFRAMEBUFFEROESPROC bind_framebuffer;
static PFNGLFRAMEBUFFERTEXTURE2DOESPROC framebuffer_texture;
static PFNGLCHECKFRAMEBUFFERSTATUSOESPROC check_framebuffer;

static void load_functions(void) {
  *(void**)&blend_func_separate = SDL_GL_GetProcAddress("glBlendFuncSeparateOES");
  *(void**)&gen_framebuffers = SDL_GL_GetProcAddress("glGenFramebuffersOES");
  *(void**)&bind_framebuffer = SDL_GL_GetProcAddress("glBindFramebufferOES");
  *(void**)&framebuffer_texture = SDL_GL_GetProcAddress("glFramebufferTexture2DOES");
  *(void**)&check_framebuffer = SDL_GL_GetProcAddress("glCheckFramebufferStatusOES");
  if (!blend_func_separate || !gen_framebuffers || !bind_framebuffer || !framebuffer_texture ||
      !check_framebuffer) {
    die("a function of an extension is missing");
  }
}

static void gles_paint(Paint p) {
  glColor4ub(p.colour.r, p.colour.g, p.colour.b, p.colour.a);
  glEnable(GL_BLEND);
  switch (p.blend) {
    case SDL_BLENDMODE_BLEND:
      blend_func_separate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      break;
    case SDL_BLENDMODE_ADD:
      blend_func_separate(GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
      break;
    case SDL_BLENDMODE_MOD:
      blend_func_separate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
      break;
    case SDL_BLENDMODE_MUL:
      blend_func_separate(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
      break;
    default:
      glDisable(GL_BLEND);
  }
}
static void gles_draw(GLenum mode, const float* vertices, int count) {
  glVertexPointer(2, GL_FLOAT, 0, vertices);
  glDrawArrays(mode, 0, count);
}
static void gles_clear(SDL_Color c) {
  glClearColor(c.r / 255.0f, c.g / 255.0f, c.b / 255.0f, c.a / 255.0f);
  glClear(GL_COLOR_BUFFER_BIT);
}
static void gles_points(Paint p, const SDL_Point* points, int count) {
  gles_paint(p);
  for (int i = 0; i < count; ++i) {
    const float centre[] = {points[i].x + 0.5f, points[i].y + 0.5f};
    gles_draw(GL_POINTS, centre, 1);
  }
}
static void gles_line(Paint p, SDL_Point from, SDL_Point to) {
  gles_paint(p);
  const float centres[] = {from.x + 0.5f, from.y + 0.5f, to.x + 0.5f, to.y + 0.5f};
  gles_draw(GL_LINES, centres, 2);
  gles_draw(GL_POINTS, centres + 2, 1); /* OpenGL leaves the last pixel out */
}
static void gles_fill(Paint p, SDL_Rect r) {
  gles_paint(p);
  const float x0 = (float)r.x, y0 = (float)r.y, x1 = x0 + (float)r.w, y1 = y0 + (float)r.h;
  const float corners[] = {x0, y0, x1, y0, x0, y1, x1, y1};
  gles_draw(GL_TRIANGLE_STRIP, corners, 4);
}
static void gles_copy(Paint p, Image* image, SDL_Rect from, SDL_Rect to, double angle,
                      SDL_RendererFlip flip) {
  gles_paint(p);
  float s0 = (float)from.x / (float)image->width;
  float s1 = (float)(from.x + from.w) / (float)image->width;
  float t0 = (float)from.y / (float)image->height;
  float t1 = (float)(from.y + from.h) / (float)image->height;
  if (flip & SDL_FLIP_HORIZONTAL) {
    const float s = s0;
    s0 = s1;
    s1 = s;
  }
  if (flip & SDL_FLIP_VERTICAL) {
    const float t = t0;
    t0 = t1;
    t1 = t;
  }
  const float texels[] = {s0, t0, s1, t0, s0, t1, s1, t1};
  const float x = (float)to.w / 2, y = (float)to.h / 2;
  const float corners[] = {-x, -y, x, -y, -x, y, x, y};
  glPushMatrix();
  glTranslatef((float)to.x + x, (float)to.y + y, 0);
  glRotatef((float)angle, 0, 0, 1);
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, image->name);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, 0, texels);
  gles_draw(GL_TRIANGLE_STRIP, corners, 4);
  glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  glDisable(GL_TEXTURE_2D);
  glPopMatrix();
}
/* Rows go down in the window; in a texture the first row is that of t = 0. */
static void gles_set_target(Image* image) {
  const int width = image ? image->width : kSize, height = image ? image->height : kSize;
  if (image && image->framebuffer == 0) {
    gen_framebuffers(1, &image->framebuffer);
    bind_framebuffer(GL_FRAMEBUFFER_OES, image->framebuffer);
    framebuffer_texture(GL_FRAMEBUFFER_OES, GL_COLOR_ATTACHMENT0_OES, GL_TEXTURE_2D, image->name,
                        0);
    if (check_framebuffer(GL_FRAMEBUFFER_OES) != GL_FRAMEBUFFER_COMPLETE_OES) die("framebuffer");
  }
  bind_framebuffer(GL_FRAMEBUFFER_OES, image ? image->framebuffer : 0);
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  if (image) {
    glOrthof(0, (float)width, 0, (float)height, 0, 1);
  } else {
    glOrthof(0, (float)width, (float)height, 0, 0, 1);
  }
  glMatrixMode(GL_MODELVIEW);
}

static const Painter kGles = {gles_clear, gles_points, gles_line,
                              gles_fill,  gles_copy,   gles_set_target};

/* A disc of changing colours and alpha; or nothing yet. */
static Image make_image(int size, int is_target) {
  Image image = {size, size, NULL, 0, 0};
  Uint8* pixels = calloc((size_t)(size * size), 4);
  if (!pixels) die("memory");
  for (int y = 0; y < size && !is_target; ++y) {
    for (int x = 0; x < size; ++x) {
      Uint8* p = pixels + 4 * (y * size + x);
      const int dx = 2 * x + 1 - size, dy = 2 * y + 1 - size;
      const int distance = dx * dx + dy * dy, radius = size * size;
      p[0] = (Uint8)(x * 255 / (size - 1));
      p[1] = (Uint8)(y * 255 / (size - 1));
      p[2] = (x / 4 + y / 4) % 2 ? 230 : 40;
      p[3] = distance > radius ? 0 : distance > radius / 2 ? 128 : 255;
    }
  }
  image.software = SDL_CreateTexture(
      software, SDL_PIXELFORMAT_RGBA32,
      is_target ? SDL_TEXTUREACCESS_TARGET : SDL_TEXTUREACCESS_STATIC, size, size);
  if (!image.software || SDL_UpdateTexture(image.software, NULL, pixels, 4 * size)) die("texture");
  glGenTextures(1, &image.name);
  glBindTexture(GL_TEXTURE_2D, image.name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  free(pixels);
  return image;
}

static Paint paint(SDL_BlendMode blend, int r, int g, int b, int a) {
  const Paint p = {blend, {(Uint8)r, (Uint8)g, (Uint8)b, (Uint8)a}};
  return p;
}

static void draw_scene(const Painter* to, Image* sprite, Image* target) {
  static const SDL_BlendMode kModes[] = {SDL_BLENDMODE_NONE, SDL_BLENDMODE_BLEND, SDL_BLENDMODE_ADD,
                                         SDL_BLENDMODE_MOD, SDL_BLENDMODE_MUL};
  const SDL_Rect whole = {0, 0, kSprite, kSprite}, all = {0, 0, kTarget, kTarget};
  const SDL_RendererFlip kNone = SDL_FLIP_NONE;
  const Paint plain = paint(SDL_BLENDMODE_BLEND, 255, 255, 255, 255);

  /* A render target, used below. */
  to->set_target(target);
  to->clear((SDL_Color){60, 20, 90, 255});
  to->fill(paint(SDL_BLENDMODE_NONE, 200, 180, 20, 255), (SDL_Rect){4, 8, 30, 12});
  to->copy(plain, sprite, whole, (SDL_Rect){28, 30, kSprite, kSprite}, 0, kNone);
  to->line(paint(SDL_BLENDMODE_NONE, 255, 255, 255, 255), (SDL_Point){2, 60}, (SDL_Point){40, 22});
  to->set_target(NULL);

  to->clear((SDL_Color){30, 60, 100, 255});
  to->fill(paint(SDL_BLENDMODE_NONE, 140, 150, 160, 255), (SDL_Rect){0, 48, kSize, 48});
  for (int i = 0; i < 5; ++i) {
    const int x = 8 + 48 * i;
    /* A sprite as it is, half of one in two colours, and a rectangle, in each mode. */
    to->copy(paint(kModes[i], 255, 255, 255, 255), sprite, whole,
             (SDL_Rect){x, 6, kSprite, kSprite}, 0, kNone);
    to->copy(paint(kModes[i], 255, 128, 200, 160), sprite, (SDL_Rect){0, 8, kSprite, 16},
             (SDL_Rect){x, 40, kSprite, 16}, 0, kNone);
    to->fill(paint(kModes[i], 220, 90, 30, 100), (SDL_Rect){x, 64, 40, 14});
    to->fill(paint(kModes[i], 10, 200, 120, 255), (SDL_Rect){x + 12, 70, 36, 20});
  }
  /* Lines in all directions that agree on every pixel, their ends too; points; outlines. */
  for (int i = 0; i < 4; ++i) {
    const SDL_Point centre = {28, 124};
    const SDL_Point ends[] = {{52, 124 - 8 * i}, {52, 124 + 24}, {28 - 6 * i, 148}, {4, 100}};
    to->line(paint(SDL_BLENDMODE_NONE, 255, 60 * i, 90, 255), i == 0 || i == 3 ? centre : ends[2],
             i == 0   ? ends[0]
             : i == 3 ? ends[3]
                      : (SDL_Point){28 - 6 * i, 100});
  }
  to->line(paint(SDL_BLENDMODE_BLEND, 255, 255, 0, 128), (SDL_Point){60, 100},
           (SDL_Point){100, 140});
  to->line(paint(SDL_BLENDMODE_ADD, 0, 200, 255, 128), (SDL_Point){100, 100}, (SDL_Point){60, 140});
  for (int i = 0; i < 24; ++i) {
    const SDL_Point point = {112 + 7 * i % 40, 100 + 11 * i % 40};
    to->points(paint(SDL_BLENDMODE_BLEND, 255, 10 * i, 255 - 10 * i, 200), &point, 1);
  }
  const SDL_Point box[] = {{160, 102}, {196, 102}, {196, 138}, {160, 138}, {160, 102}};
  for (int i = 0; i < 4; ++i)
    to->line(paint(SDL_BLENDMODE_NONE, 250, 250, 250, 255), box[i], box[i + 1]);
  /* Doubled, mirrored, and the target's picture. */
  to->copy(plain, sprite, whole, (SDL_Rect){2, 128, 2 * kSprite, 2 * kSprite}, 0, kNone);
  to->copy(plain, sprite, whole, (SDL_Rect){70, 146, kSprite, kSprite}, 0, SDL_FLIP_HORIZONTAL);
  to->copy(plain, sprite, whole, (SDL_Rect){104, 146, kSprite, kSprite}, 0, SDL_FLIP_VERTICAL);
  to->copy(plain, target, all, (SDL_Rect){140, 124, kTarget, kTarget}, 0, kNone);
  to->copy(paint(SDL_BLENDMODE_ADD, 255, 255, 255, 128), target, all,
           (SDL_Rect){200, 100, kTarget, kTarget}, 0, kNone);
  /* Rotated. */
  static const double kAngles[] = {90, 180, 30, 45, 200, 317};
  for (int i = 0; i < 6; ++i) {
    to->copy(paint(SDL_BLENDMODE_BLEND, 255, 255, 255, 255), sprite, whole,
             (SDL_Rect){6 + 42 * i, kRotatedTop + 16, kSprite, kSprite}, kAngles[i],
             i % 2 ? SDL_FLIP_HORIZONTAL : SDL_FLIP_NONE);
  }
}

/* The largest difference of a component; alpha is not shown. */
static int difference(const Uint8* a, const Uint8* b) {
  int largest = 0;
  for (int i = 0; i < 3; ++i) largest = SDL_max(largest, abs(a[i] - b[i]));
  return largest;
}

int main(int argc, char** argv) {
  SDL_SetHint(SDL_HINT_VIDEO_X11_FORCE_EGL, "1");
  SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "0");
  if (SDL_Init(SDL_INIT_VIDEO)) die("SDL_Init");
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 1);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 1);
  SDL_GL_SetAttribute(SDL_GL_RED_SIZE, 8);
  SDL_GL_SetAttribute(SDL_GL_GREEN_SIZE, 8);
  SDL_GL_SetAttribute(SDL_GL_BLUE_SIZE, 8);
  SDL_Window* window = SDL_CreateWindow("sprites", 10, 10, kSize, kSize, SDL_WINDOW_OPENGL);
  if (!window) die("SDL_CreateWindow");
  SDL_GLContext context = SDL_GL_CreateContext(window);
  if (!context) die("SDL_GL_CreateContext");
  load_functions();
  printf("sdl_sprites: %s, %s, %s\n", SDL_GetCurrentVideoDriver(), glGetString(GL_VERSION),
         glGetString(GL_RENDERER));

  /* Both pictures, side by side. */
  SDL_Surface* both =
      SDL_CreateRGBSurfaceWithFormat(0, 2 * kSize, kSize, 32, SDL_PIXELFORMAT_RGBA32);
  SDL_Surface* memory = SDL_CreateRGBSurfaceWithFormat(0, kSize, kSize, 32, SDL_PIXELFORMAT_RGBA32);
  if (!both || !memory) die("surface");
  software = SDL_CreateSoftwareRenderer(memory);
  if (!software) die("software renderer");
  Image sprite = make_image(kSprite, 0), target = make_image(kTarget, 1);
  draw_scene(&kSoftware, &sprite, &target);
  SDL_RenderFlush(software);

  glEnableClientState(GL_VERTEX_ARRAY);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  SDL_GL_SetSwapInterval(1);
  static Uint8 drawn[kSize][kSize][4];
  for (int frame = 0; frame < 4; ++frame) {
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
    }
    draw_scene(&kGles, &sprite, &target);
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, drawn);
    SDL_GL_SwapWindow(window);
  }
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) {
    fprintf(stderr, "sdl_sprites: GL error 0x%04x\n", error);
    return 1;
  }

  int largest = 0, wrong = 0;
  int sums[(kSize - kRotatedTop) / kBlock][kSize / kBlock][3] = {0};
  for (int y = 0; y < kSize; ++y) {
    const Uint8* row = (const Uint8*)memory->pixels + y * memory->pitch;
    Uint8* out = (Uint8*)both->pixels + y * both->pitch;
    memcpy(out, row, 4 * kSize);
    memcpy(out + 4 * kSize, drawn[kSize - 1 - y], 4 * kSize);
    for (int x = 0; x < kSize; ++x) {
      const Uint8 *expected = row + 4 * x, *actual = drawn[kSize - 1 - y][x];
      if (y >= kRotatedTop) {
        int* sum = sums[(y - kRotatedTop) / kBlock][x / kBlock];
        for (int i = 0; i < 3; ++i) sum[i] += actual[i] - expected[i];
      } else {
        const int d = difference(expected, actual);
        largest = SDL_max(largest, d);
        wrong += d > kTolerance;
      }
    }
  }
  int block_largest = 0;
  const int* sum = &sums[0][0][0];
  for (size_t i = 0; i < sizeof(sums) / sizeof(*sum); ++i) {
    block_largest = SDL_max(block_largest, abs(sum[i]) / (kBlock * kBlock));
  }
  printf(
      "sdl_sprites: the largest difference is %d/255, %d pixels differ by more than %d/255; means "
      "of rotated copies differ by up to %d/255\n",
      largest, wrong, kTolerance, block_largest);
  if (argc > 1 && SDL_SaveBMP(both, argv[1])) die(argv[1]);

  SDL_DestroyTexture(sprite.software);
  SDL_DestroyTexture(target.software);
  SDL_DestroyRenderer(software);
  SDL_FreeSurface(memory);
  SDL_FreeSurface(both);
  SDL_GL_DeleteContext(context);
  SDL_DestroyWindow(window);
  SDL_Quit();
  return wrong > 0 || block_largest > kBlockTolerance ? 1 : 0;
}
