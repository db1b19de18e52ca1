// breakout.c - a wall of bricks, a ball and a paddle
//
// Left and Right on the PS/2 keyboard, or KEY3 and KEY2, move the paddle.  Space, or KEY0, serves; after
// the last ball it begins a new game.  With SW9 on, the paddle follows the ball by itself.  HEX shows the
// score, LEDR the balls that are left.
//
// The game moves on by one step per picture, so 60 per second.  Sound comes from the audio core's
// interrupt, since a picture takes longer than the core's store of samples lasts.
#include "processor.h"
#include "screen.h"

enum { WRITE_INTERRUPT = 2, RATE_HZ = 8000, LOUD = 0x18000000 };

// ---- Sound ----

static volatile unsigned half_period, samples_left;  // of the tone; in samples

static void beep(unsigned hz, unsigned ms) {
    half_period = RATE_HZ / 2 / hz;
    samples_left = RATE_HZ * ms / 1000;
}

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();
    while (id == AUDIO_INTERRUPT && AUDIO_FIFOSPACE & 0x00FF0000) {
        uint32_t sample = 0;
        if (samples_left > 0) {
            sample = samples_left / half_period % 2 ? LOUD : (uint32_t)-LOUD;
            --samples_left;
        }
        AUDIO_LEFTDATA = sample;
        AUDIO_RIGHTDATA = sample;
    }
    interrupt_end(id);
}

// ---- Keys ----

struct Input {
    int left, right, serve;
};

// A key sends its code when it is pressed and 0xF0 before it when it is let go.  The arrows' codes begin
// with 0xE0, which may be passed over here.
static void read_keyboard(struct Input* input) {
    static int released;
    for (uint32_t data = PS2_0_DATA; data & 0x8000; data = PS2_0_DATA) {
        const uint32_t code = data & 0xFF;
        if (code == 0x6B) input->left = !released;
        if (code == 0x74) input->right = !released;
        if (code == 0x29) input->serve = !released;
        released = code == 0xF0;
    }
}

static struct Input read_input(void) {
    static struct Input keyboard;
    read_keyboard(&keyboard);
    const struct Input input = {keyboard.left || KEY_DATA & 8, keyboard.right || KEY_DATA & 4,
                                keyboard.serve || KEY_DATA & 1};
    return input;
}

// ---- Game ----

enum { BRICK_COLUMNS = 10, BRICK_ROWS = 6, BRICK_WIDTH = 32, BRICK_HEIGHT = 10, WALL_TOP = 30 };
enum { PADDLE_WIDTH = 40, PADDLE_HEIGHT = 5, PADDLE_Y = 220, PADDLE_SPEED = 4, BALL = 4, BALLS = 3 };
enum { FINE = 16 };  // the ball's place and speed are in sixteenths of a pixel

struct Game {
    uint8_t bricks[BRICK_ROWS][BRICK_COLUMNS];  // 1: still there
    int bricks_left, balls, score;
    int paddle;        // its left end
    int x, y, dx, dy;  // of the ball's upper left corner; speeds per step
    int in_play;       // else the ball lies on the paddle
};

static void begin(struct Game* game) {
    for (int row = 0; row < BRICK_ROWS; ++row)
        for (int column = 0; column < BRICK_COLUMNS; ++column) game->bricks[row][column] = 1;
    game->bricks_left = BRICK_ROWS * BRICK_COLUMNS;
    game->balls = BALLS;
    game->score = 0;
    game->paddle = (WIDTH - PADDLE_WIDTH) / 2;
    game->x = game->y = 0;
    game->in_play = 0;
}

static void move_paddle(struct Game* game, const struct Input* input) {
    const int by_itself = SW_DATA >> 9 & 1;
    const int aim = game->paddle + 6 + game->score * 7 % 28;  // hits with another part each time
    const int ball = game->x / FINE + BALL / 2;
    if (input->left || (by_itself && ball < aim - 2)) game->paddle -= PADDLE_SPEED;
    if (input->right || (by_itself && ball > aim + 2)) game->paddle += PADDLE_SPEED;
    if (game->paddle < 0) game->paddle = 0;
    if (game->paddle > WIDTH - PADDLE_WIDTH) game->paddle = WIDTH - PADDLE_WIDTH;
}

// The brick at the ball's middle, if there is one, goes.  The ball turns round up or down if it came from
// above or below, else left or right.
static void hit_brick(struct Game* game) {
    const int x = game->x / FINE + BALL / 2, y = game->y / FINE + BALL / 2 - WALL_TOP;
    const int row = y / BRICK_HEIGHT, column = x / BRICK_WIDTH;
    if (y < 0 || row >= BRICK_ROWS || !game->bricks[row][column]) return;
    game->bricks[row][column] = 0;
    --game->bricks_left;
    game->score += BRICK_ROWS - row;
    const int row_before = (y - game->dy / FINE) / BRICK_HEIGHT;
    if (row_before != row || y - game->dy / FINE < 0)
        game->dy = -game->dy;
    else
        game->dx = -game->dx;
    beep(880 - 80 * (unsigned)row, 60);
}

static void hit_paddle(struct Game* game) {
    const int x = game->x / FINE + BALL / 2 - game->paddle, y = game->y / FINE + BALL;
    if (game->dy < 0 || y < PADDLE_Y || y > PADDLE_Y + 2 * PADDLE_HEIGHT) return;
    if (x < 0 || x > PADDLE_WIDTH) return;
    game->dy = -game->dy;
    game->dx = (x - PADDLE_WIDTH / 2) * 3;  // at its ends the paddle sends the ball aside
    beep(300, 40);
}

static void move_ball(struct Game* game) {
    game->x += game->dx;
    game->y += game->dy;
    if ((game->x < 0 && game->dx < 0) || (game->x > (WIDTH - BALL) * FINE && game->dx > 0))
        game->dx = -game->dx;
    if (game->y < 0 && game->dy < 0) game->dy = -game->dy;
    if (game->x < 0) game->x = 0;
    hit_brick(game);
    hit_paddle(game);
    if (game->y < HEIGHT * FINE) return;
    game->in_play = 0;
    --game->balls;
    beep(110, 400);
}

static void step(struct Game* game, const struct Input* input) {
    move_paddle(game, input);
    if (game->in_play) {
        move_ball(game);
        return;
    }
    game->x = (game->paddle + PADDLE_WIDTH / 2 - BALL / 2) * FINE;
    game->y = (PADDLE_Y - BALL) * FINE;
    if (!input->serve) return;
    if (game->balls == 0 || game->bricks_left == 0) begin(game);
    game->in_play = 1;
    game->dx = 20;
    game->dy = -44;
}

// ---- Picture ----

static void draw(const struct Game* game) {
    static const uint8_t COLOURS[BRICK_ROWS][3] = {{230, 60, 60},  {240, 140, 40}, {240, 220, 60},
                                                   {90, 200, 80}, {60, 150, 230}, {150, 90, 220}};
    screen_clear(rgb(10, 10, 30));
    for (int row = 0; row < BRICK_ROWS; ++row)
        for (int column = 0; column < BRICK_COLUMNS; ++column)
            if (game->bricks[row][column])
                screen_fill(column * BRICK_WIDTH + 1, WALL_TOP + row * BRICK_HEIGHT + 1,
                            BRICK_WIDTH - 2, BRICK_HEIGHT - 2,
                            rgb(COLOURS[row][0], COLOURS[row][1], COLOURS[row][2]));
    screen_fill(game->paddle, PADDLE_Y, PADDLE_WIDTH, PADDLE_HEIGHT, rgb(220, 220, 220));
    screen_fill(game->x / FINE, game->y / FINE, BALL, BALL, rgb(255, 255, 255));
}

static void write(const struct Game* game) {
    const char* message = "                    ";
    if (!game->in_play) message = "Press Space to serve";
    if (game->balls == 0) message = "     Game over      ";
    if (game->bricks_left == 0) message = "      You win!      ";
    screen_text(30, 36, message);
    const unsigned score = (unsigned)game->score;
    HEX3_0_DATA = (uint32_t)DIGITS[score / 100 % 10] << 16 | (uint32_t)DIGITS[score / 10 % 10] << 8 |
             DIGITS[score % 10];
    LEDR_DATA = (1u << game->balls) - 1;
}

int main(void) {
    struct Game game;
    screen_begin();
    begin(&game);
    interrupt_on(AUDIO_INTERRUPT);
    AUDIO_CONTROL = WRITE_INTERRUPT;
    interrupts_enable();
    for (;;) {
        const struct Input input = read_input();
        step(&game, &input);
        draw(&game);
        write(&game);
        screen_show();
    }
}
