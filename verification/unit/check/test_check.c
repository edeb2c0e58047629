/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each check of the computer says in a sentence what it has found, good and not,
 * and is good when that is. Files of the kernel are those of a folder of the test.
 */
#include "check/check.h"

#include "unity.h"

#include "card/card_dialect.h"
#include "check/check_files.h"
#include "check/realtime.h"
#include "exchange/exchange.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define PATH_SIZE 256U
#define INTERRUPTS "           CPU0       CPU1\n"

static char root[] = "/tmp/boresight-check-XXXXXX";
static check_facts_t facts;
static char found[CHECK_TEXT_SIZE];

static int remove_one(const char *path, const struct stat *about, int kind, struct FTW *where)
{
    (void)about;
    (void)kind;
    (void)where;
    return remove(path);
}

void setUp(void)
{
    (void)strcpy(&root[sizeof root - 7U], "XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(root));
    facts = (check_facts_t){.root = root, .core = 1U, .cores = 2U, .clock_ns = 1U};
}

void tearDown(void)
{
    (void)nftw(root, remove_one, 8, FTW_DEPTH | FTW_PHYS);
}

/* Writes a file of the kernel, with the folders above it. */
static void write_file(const char *path, const char *text)
{
    char whole[PATH_SIZE];
    (void)snprintf(whole, sizeof whole, "%s%s", root, path);
    for (char *slash = strchr(&whole[strlen(root) + 1U], '/'); slash != NULL;
         slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        (void)mkdir(whole, 0700);
        *slash = '/';
    }
    FILE *const file = fopen(whole, "w");
    TEST_ASSERT_NOT_NULL(file);
    (void)fputs(text, file);
    (void)fclose(file);
}

static void expect(bool is_good, computer_check_t check, const char *sentence)
{
    found[0] = '\0';
    TEST_ASSERT_EQUAL(is_good, check_is_good(&facts, check, found));
    TEST_ASSERT_EQUAL_STRING(sentence, found);
}

/* With `text` in the file `path`. */
static void expect_of(const char *path, const char *text, bool is_good, computer_check_t check,
                      const char *sentence)
{
    write_file(path, text);
    expect(is_good, check, sentence);
}

void test_SWR_CHECK_002_the_kernel(void)
{
    expect(false, COMPUTER_CHECK_KERNEL, "/proc/version cannot be read.");
    expect_of("/proc/version", "Linux version 6.1 (a@b) #1 SMP PREEMPT_DYNAMIC Mon\n", false,
              COMPUTER_CHECK_KERNEL, "The kernel is #1 SMP PREEMPT_DYNAMIC Mon.");
    expect_of("/proc/version", "Linux version 6.1 (a@b) #1 SMP PREEMPT_RT Mon\n", true,
              COMPUTER_CHECK_KERNEL, "The kernel is #1 SMP PREEMPT_RT Mon.");
    expect_of("/proc/version", "Linux version 4.14 #1 SMP PREEMPT RT Mon\n", true,
              COMPUTER_CHECK_KERNEL, "The kernel is #1 SMP PREEMPT RT Mon.");
    expect_of("/proc/version", "Linux\n", false, COMPUTER_CHECK_KERNEL, "The kernel is Linux.");
    expect_of("/sys/kernel/realtime", "0\n", false, COMPUTER_CHECK_KERNEL, "The kernel is Linux.");
    expect_of("/sys/kernel/realtime", "1\n", true, COMPUTER_CHECK_KERNEL,
              "The kernel is PREEMPT_RT.");
}

void test_SWR_CHECK_002_throttling(void)
{
    const char *const path = "/proc/sys/kernel/sched_rt_runtime_us";
    expect(false, COMPUTER_CHECK_THROTTLING, "sched_rt_runtime_us cannot be read.");
    expect_of(path, "950000\n", false, COMPUTER_CHECK_THROTTLING, "sched_rt_runtime_us is 950000.");
    expect_of(path, "-1\n", true, COMPUTER_CHECK_THROTTLING, "sched_rt_runtime_us is -1.");
}

void test_SWR_CHECK_002_rights(void)
{
    expect(false, COMPUTER_CHECK_RIGHTS, "Real-time priority is refused, memory is not locked.");
    facts.rights = EXCHANGE_RIGHT_FIFO;
    expect(false, COMPUTER_CHECK_RIGHTS, "Real-time priority is granted, memory is not locked.");
    facts.rights = EXCHANGE_RIGHT_MEMORY;
    expect(false, COMPUTER_CHECK_RIGHTS, "Real-time priority is refused, memory is locked.");
    facts.rights = EXCHANGE_RIGHT_FIFO | EXCHANGE_RIGHT_MEMORY;
    expect(true, COMPUTER_CHECK_RIGHTS, "Real-time priority is granted, memory is locked.");
}

void test_SWR_CHECK_002_page_faults(void)
{
    facts.cycles = 5000U;
    expect(true, COMPUTER_CHECK_PAGE_FAULTS,
           "0 page faults in 5000 cycles, 0 of them from the disk.");
    facts.minor_faults = 3U;
    expect(false, COMPUTER_CHECK_PAGE_FAULTS,
           "3 page faults in 5000 cycles, 0 of them from the disk.");
    facts.major_faults = 2U;
    expect(false, COMPUTER_CHECK_PAGE_FAULTS,
           "5 page faults in 5000 cycles, 2 of them from the disk.");
    facts.minor_faults = 0U;
    expect(false, COMPUTER_CHECK_PAGE_FAULTS,
           "2 page faults in 5000 cycles, 2 of them from the disk.");
}

void test_SWR_CHECK_002_a_core_of_its_own(void)
{
    const char *const path = "/sys/devices/system/cpu/isolated";
    expect(false, COMPUTER_CHECK_OWN_CORE, "Core 1 of 2 is not isolated.");
    expect_of(path, "\n", false, COMPUTER_CHECK_OWN_CORE, "Core 1 of 2 is not isolated.");
    expect_of(path, "2-3\n", false, COMPUTER_CHECK_OWN_CORE, "Core 1 of 2 is not isolated.");
    expect_of("/proc/cmdline", "quiet isolcpus=nohz,domain,1 rw\n", true, COMPUTER_CHECK_OWN_CORE,
              "Core 1 of 2 is isolated.");
    expect_of("/proc/cmdline", "quiet isolcpus= nohz_full=1\n", false, COMPUTER_CHECK_OWN_CORE,
              "Core 1 of 2 is not isolated.");
    expect_of(path, "0,1-2\n", true, COMPUTER_CHECK_OWN_CORE, "Core 1 of 2 is isolated.");
    facts.cores = 1U;
    expect(false, COMPUTER_CHECK_OWN_CORE, "There is one core only.");
}

void test_SWR_CHECK_002_interrupts_of_devices(void)
{
    const char *const path = "/proc/interrupts";
    expect(false, COMPUTER_CHECK_INTERRUPTS, "/proc/interrupts cannot be read.");
    write_file("/proc/irq/54/smp_affinity_list", "0\n");
    expect_of(path,
              INTERRUPTS " 54:        120          0   GIC-0  54 Level     eth0\n"
                         " 55:          0          0   GIC-0  55 Level     unused\n"
                         "LOC:       4000       5000   Local timer interrupts\n"
                         "ERR:          0\n",
              true, COMPUTER_CHECK_INTERRUPTS, "No device interrupts core 1.");
    expect_of("/proc/irq/54/smp_affinity_list", "0-1\n", false, COMPUTER_CHECK_INTERRUPTS,
              "Interrupt 54 (eth0) may come to core 1.");
    expect_of("/proc/irq/54/effective_affinity_list", "0\n", true, COMPUTER_CHECK_INTERRUPTS,
              "No device interrupts core 1.");
    expect_of("/proc/irq/default_smp_affinity", "3\n", false, COMPUTER_CHECK_INTERRUPTS,
              "New interrupts may come to core 1 (default_smp_affinity).");
    expect_of("/proc/irq/default_smp_affinity", "1\n", true, COMPUTER_CHECK_INTERRUPTS,
              "No device interrupts core 1.");
}

/* As a Cortex-A9 and a newer ARM have them; no program can move them. */
void test_SWR_CHECK_011_the_timer_of_an_arm_core_is_no_device(void)
{
    static const char *const names[] = {"GIC-0  29 Edge      twd", "GIC-0  27 Edge      gt",
                                        "GICv2  30 Level     arch_timer"};
    char line[200];
    write_file("/proc/irq/default_smp_affinity", "1\n");
    write_file("/proc/irq/24/smp_affinity_list", "0-1\n");
    for (size_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        (void)snprintf(line, sizeof line, INTERRUPTS " 24:  1000  5031     %s\n", names[i]);
        expect_of("/proc/interrupts", line, true, COMPUTER_CHECK_INTERRUPTS,
                  "No device interrupts core 1.");
    }
    expect_of("/proc/interrupts", INTERRUPTS " 24:  1000  5031     GIC-0  29 Edge  other_gt\n",
              false, COMPUTER_CHECK_INTERRUPTS,
              "Interrupt 24 (other_gt) has come 5031 times to core 1.");
}

/* An interrupt before the first look does not count. */
void test_SWR_CHECK_002_an_interrupt_that_has_come_meanwhile(void)
{
    const char *const path = "/proc/interrupts";
    write_file(path, INTERRUPTS " 54:        120          7   GIC-0  54 Level     eth0\n");
    check_count_interrupts(root, 1U, facts.interrupts);
    TEST_ASSERT_EQUAL_UINT64(7U, facts.interrupts[54]);
    expect(true, COMPUTER_CHECK_INTERRUPTS, "No device interrupts core 1.");
    expect_of(path, INTERRUPTS " 54:        120         19   GIC-0  54 Level     eth0\n", false,
              COMPUTER_CHECK_INTERRUPTS, "Interrupt 54 (eth0) has come 12 times to core 1.");
}

void test_SWR_CHECK_002_work_queues(void)
{
    const char *const path = "/sys/devices/virtual/workqueue/cpumask";
    expect(false, COMPUTER_CHECK_WORK_QUEUES, "The work queues' mask cannot be read.");
    expect_of(path, "3\n", false, COMPUTER_CHECK_WORK_QUEUES,
              "Core 1 is in the work queues' mask 3.");
    expect_of(path, "ff,00000001\n", true, COMPUTER_CHECK_WORK_QUEUES,
              "Core 1 is not in the work queues' mask ff,00000001.");
    facts.core = 33U;
    expect(false, COMPUTER_CHECK_WORK_QUEUES, "Core 33 is in the work queues' mask ff,00000001.");
    facts.core = 63U;
    expect(true, COMPUTER_CHECK_WORK_QUEUES,
           "Core 63 is not in the work queues' mask ff,00000001.");
}

void test_SWR_CHECK_002_the_governor(void)
{
    const char *const path = "/sys/devices/system/cpu/cpu1/cpufreq/scaling_governor";
    expect(true, COMPUTER_CHECK_GOVERNOR, "The clock of core 1 has no governor.");
    expect_of(path, "ondemand\n", false, COMPUTER_CHECK_GOVERNOR,
              "The governor of core 1 is ondemand.");
    expect_of(path, "performance\n", true, COMPUTER_CHECK_GOVERNOR,
              "The governor of core 1 is performance.");
}

void test_SWR_CHECK_002_sleep(void)
{
    expect(true, COMPUTER_CHECK_IDLE, "Core 1 wakes from its deepest sleep in 0 us.");
    write_file("/sys/devices/system/cpu/cpu1/cpuidle/state1/disable", "0\n");
    expect_of("/sys/devices/system/cpu/cpu1/cpuidle/state1/latency", "9\n", true,
              COMPUTER_CHECK_IDLE, "Core 1 wakes from its deepest sleep in 9 us.");
    expect_of("/sys/devices/system/cpu/cpu1/cpuidle/state2/latency", "133\n", false,
              COMPUTER_CHECK_IDLE, "Core 1 wakes from its deepest sleep in 133 us.");
    facts.is_awake = true;
    expect(true, COMPUTER_CHECK_IDLE,
           "Core 1 wakes from its deepest sleep in 133 us; control keeps it awake.");
    facts.is_awake = false;
    expect_of("/sys/devices/system/cpu/cpu1/cpuidle/state2/disable", "1\n", true,
              COMPUTER_CHECK_IDLE, "Core 1 wakes from its deepest sleep in 9 us.");
    expect_of("/sys/devices/system/cpu/cpu1/cpuidle/state1/latency", "10\n", false,
              COMPUTER_CHECK_IDLE, "Core 1 wakes from its deepest sleep in 10 us.");
}

void test_SWR_CHECK_002_the_clock(void)
{
    const char *const path = "/sys/devices/system/clocksource/clocksource0/current_clocksource";
    expect(false, COMPUTER_CHECK_CLOCK, "The clock source cannot be read.");
    expect_of(path, "jiffies\n", false, COMPUTER_CHECK_CLOCK,
              "The clock source is jiffies, its steps are 1 ns.");
    expect_of(path, "refined-jiffies\n", false, COMPUTER_CHECK_CLOCK,
              "The clock source is refined-jiffies, its steps are 1 ns.");
    expect_of(path, "hpet\n", false, COMPUTER_CHECK_CLOCK,
              "The clock source is hpet, its steps are 1 ns.");
    expect_of(path, "arm_global_timer\n", true, COMPUTER_CHECK_CLOCK,
              "The clock source is arm_global_timer, its steps are 1 ns.");
    facts.clock_ns = 4000000U;
    expect(false, COMPUTER_CHECK_CLOCK,
           "The clock source is arm_global_timer, its steps are 4000000 ns.");
}

void test_SWR_CHECK_002_timers(void)
{
    expect(true, COMPUTER_CHECK_TIMERS, "High-resolution timers are active.");
    expect_of("/proc/timer_list", "cpu: 0\n  .hres_active    : 1\n  .hres_active    : 0\n", false,
              COMPUTER_CHECK_TIMERS, "High-resolution timers are not active.");
    expect_of("/proc/timer_list", "cpu: 0\n  .hres_active    : 1\n", true, COMPUTER_CHECK_TIMERS,
              "High-resolution timers are active.");
    facts.clock_ns = 4000000U;
    expect(false, COMPUTER_CHECK_TIMERS, "High-resolution timers are not active.");
}

void test_SWR_CHECK_002_swap(void)
{
    expect(true, COMPUTER_CHECK_SWAP, "Nothing is swapped.");
    expect_of("/proc/swaps", "Filename  Type  Size\n", true, COMPUTER_CHECK_SWAP,
              "Nothing is swapped.");
    expect_of("/proc/swaps", "Filename  Type  Size\n/dev/sda2   partition 9\n", false,
              COMPUTER_CHECK_SWAP, "Memory is swapped to /dev/sda2.");
}

void test_SWR_CHECK_002_the_watchdog(void)
{
    const char *const status = "/sys/class/watchdog/watchdog0/bootstatus";
    expect(false, COMPUTER_CHECK_WATCHDOG, "There is no watchdog.");
    expect_of("/sys/class/watchdog/watchdog0/identity", "Cadence Watchdog\n", true,
              COMPUTER_CHECK_WATCHDOG, "There is the watchdog Cadence Watchdog.");
    expect_of(status, "0\n", true, COMPUTER_CHECK_WATCHDOG,
              "There is the watchdog Cadence Watchdog.");
    expect_of(status, "32\n", false, COMPUTER_CHECK_WATCHDOG,
              "The watchdog Cadence Watchdog has restarted the computer.");
}

void test_SWR_CHECK_003_the_worst_wake_up_decides(void)
{
    facts.cycles = 5000U;
    facts.wake_p99_us = 20U;
    facts.wake_worst_us = LIMIT_WAKE_UP_US;
    expect(true, COMPUTER_CHECK_WAKE_UP,
           "Of 5000 wake-ups 99 % were at most 20 us late and the worst 200 us; at most 200 us are "
           "allowed.");
    facts.wake_worst_us = LIMIT_WAKE_UP_US + 1U;
    expect(false, COMPUTER_CHECK_WAKE_UP,
           "Of 5000 wake-ups 99 % were at most 20 us late and the worst 201 us; at most 200 us are "
           "allowed.");
    facts = (check_facts_t){.root = root};
    expect(false, COMPUTER_CHECK_WAKE_UP,
           "Of 0 wake-ups 99 % were at most 0 us late and the worst 0 us; at most 200 us are "
           "allowed.");
}

/* Ten wires of 5 MHz: 2048 bits each. */
static const check_board_t thesis = {.wire_hz = 5000000U,
                                     .wires = 10U,
                                     .word_ns = 300U,
                                     .instructions_per_us = 500U,
                                     .publish_us = 30U};

void test_SWR_CTRL_020_the_cards_of_the_limit_are_those_of_the_robot(void)
{
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, LIMIT_CYCLE_CARDS);
}

void test_SWR_CHECK_004_the_budget_adds_up_what_the_board_says(void)
{
    const check_budget_t budget = check_budget(&thesis, CHECK_CARDS);
    TEST_ASSERT_EQUAL_UINT32(200U, budget.wake_us);
    TEST_ASSERT_EQUAL_UINT32(192U, budget.words_us);
    TEST_ASSERT_EQUAL_UINT32(85U, budget.step_us);
    TEST_ASSERT_EQUAL_UINT32(30U, budget.publish_us);
    TEST_ASSERT_EQUAL_UINT32(409U, budget.wire_us);
    facts.board = thesis;
    expect(
        true, COMPUTER_CHECK_BUDGET,
        "With 10 cards wake-up 200 + words 192 + step 85 + publish 30 = 507 us of 800; the wires "
        "take 409 us, frames are back after 886 us of 1000. There is time for 10 cards.");
}

/* Half the words, half the bits. */
void test_SWR_CHECK_009_frames_are_as_large_as_the_dialect_of_the_cards_has_them(void)
{
    check_board_t board = thesis;
    board.dialect = (uint32_t)CARD_DIALECT_AIM32;
    const check_budget_t budget = check_budget(&board, CHECK_CARDS);
    TEST_ASSERT_EQUAL_UINT32(96U, budget.words_us);
    TEST_ASSERT_EQUAL_UINT32(204U, budget.wire_us);
    TEST_ASSERT_EQUAL_UINT32(85U, budget.step_us);
}

/* As bsp/nifpga/board.yml has it of the thesis: its calls of eight cards take 300 us, the wires
 * 400. */
void test_SWR_CHECK_010_it_is_reported_for_how_many_cards_there_is_time(void)
{
    facts.board = (check_board_t){.wire_hz = 2560000U,
                                  .wires = 10U,
                                  .word_ns = 1170U,
                                  .instructions_per_us = 333U,
                                  .publish_us = 30U,
                                  .dialect = (uint32_t)CARD_DIALECT_AIM32};
    expect(
        false, COMPUTER_CHECK_BUDGET,
        "With 10 cards wake-up 200 + words 374 + step 128 + publish 30 = 732 us of 800; the wires "
        "take 400 us, frames are back after 1102 us of 1000. There is time for 7 cards.");
    facts.board.wire_hz = 1000000U;
    expect(
        false, COMPUTER_CHECK_BUDGET,
        "With 10 cards wake-up 200 + words 374 + step 128 + publish 30 = 732 us of 800; the wires "
        "take 1024 us, frames are back after 1726 us of 1000. There is time for 0 cards.");
}

void test_SWR_CHECK_004_wires_that_are_too_slow_or_too_few_do_not_fit(void)
{
    facts.board = thesis;
    facts.board.wires = 9U;
    expect(
        false, COMPUTER_CHECK_BUDGET,
        "With 10 cards wake-up 200 + words 192 + step 85 + publish 30 = 507 us of 800; the wires "
        "take 819 us, frames are back after 1296 us of 1000. There is time for 9 cards.");
    facts.board = thesis;
    facts.board.word_ns = 770U;
    expect(
        false, COMPUTER_CHECK_BUDGET,
        "With 10 cards wake-up 200 + words 492 + step 85 + publish 30 = 807 us of 800; the wires "
        "take 409 us, frames are back after 1186 us of 1000. There is time for 6 cards.");
}

void test_SWR_CHECK_004_a_real_board_has_to_say_what_it_costs(void)
{
    expect(false, COMPUTER_CHECK_BUDGET, "The board says nothing of its wires.");
    facts.is_simulated = true;
    expect(true, COMPUTER_CHECK_BUDGET, "The board says nothing of its wires.");
}

void test_SWR_CHECK_002_only_the_first_four_block(void)
{
    for (uint32_t i = 0U; i < COMPUTER_CHECK_COUNT; i++) {
        TEST_ASSERT_EQUAL(i < 4U, check_blocks((computer_check_t)i));
    }
}

void test_SWR_CHECK_007_the_kernel_is_asked_for_no_deep_sleep(void)
{
    char text[CHECK_FILE_SIZE] = "";
    TEST_ASSERT_FALSE(realtime_stay_awake(root));
    write_file("/dev/cpu_dma_latency", "abcdef");
    TEST_ASSERT_TRUE(realtime_stay_awake(root));
    FILE *const file = check_open(root, "/dev/cpu_dma_latency");
    TEST_ASSERT_EQUAL_size_t(6U, fread(text, 1U, sizeof text, file));
    (void)fclose(file);
    TEST_ASSERT_EQUAL_MEMORY("\0\0\0\0ef", text, 6U);
}

void test_SWR_CHECK_002_a_path_that_is_too_long_is_no_file(void)
{
    static char long_root[5000];
    char text[CHECK_FILE_SIZE];
    (void)memset(long_root, 'a', sizeof long_root - 1U);
    TEST_ASSERT_FALSE(check_read(long_root, "/proc/version", text));
    write_file("/empty", "");
    TEST_ASSERT_TRUE(check_read(root, "/empty", text));
    TEST_ASSERT_EQUAL_STRING("", text);
}
