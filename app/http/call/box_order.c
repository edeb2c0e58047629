/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/box_order.h"

#include <stdio.h>
#include <string.h>

static bool is_reported(const request_field_t *field, const request_box_order_t *request)
{
    return *(const bool *)((const char *)request + field->given_offset);
}

static const request_field_t *next_reported(const request_field_t *field,
                                            const request_box_order_t *request)
{
    const request_field_t *const end = &request_box_order.fields[request_box_order.count];
    while ((field != end) && (!is_reported(field, request) || (strcmp(field->name, "slot") == 0))) {
        field++;
    }
    return (field != end) ? field : NULL;
}

static bool needs_slot(const request_field_t *field)
{
    return (strstr(field->name, "_fault") != NULL) || (strcmp(field->name, "plug") == 0);
}

static box_order_verdict_t refuse(box_order_t *order, const char *name, box_order_verdict_t verdict)
{
    (void)snprintf(order->place, sizeof order->place, "/%s", name);
    return verdict;
}

static void write_value(const request_field_t *field, const request_box_order_t *request,
                        char *text, size_t size)
{
    const void *const value = (const char *)request + field->offset;
    if (field->kind == REQUEST_WORD) {
        (void)snprintf(text, size, "%s", field->words[*(const uint32_t *)value].word);
    } else {
        (void)snprintf(text, size, "%d", (int)*(const int32_t *)value);
    }
}

/* Without unit or "fault", words of a member's name are those of the order: "card_fault" is "card",
 * "force_hand" is "force hand". */
static void write_name(const char *name, char *text, size_t size)
{
    static const char *const endings[] = {"_fault", "_mm", "_mn", "_ms", "_um"};
    size_t length = strlen(name);
    for (size_t i = 0U; i < sizeof endings / sizeof endings[0]; i++) {
        const char *const ending = strstr(name, endings[i]);
        length = (ending != NULL) ? (size_t)(ending - name) : length;
    }
    (void)snprintf(text, size, "%.*s", (int)length, name);
    for (char *at = text; *at != '\0'; at++) {
        *at = (*at == '_') ? ' ' : *at;
    }
}

static void write_words(const request_field_t *field, const request_box_order_t *request,
                        box_order_t *order)
{
    char slot[4] = "";
    char name[24];
    char value[24];
    if (needs_slot(field)) {
        (void)snprintf(slot, sizeof slot, " %u", (unsigned)(request->slot % 10U));
    }
    write_value(field, request, value, sizeof value);
    write_name(field->name, name, sizeof name);
    (void)snprintf(order->words, sizeof order->words, "%.16s%s %s", name, slot, value);
    const bool is_drop = strcmp(value, "drop") == 0;
    order->is_safe = is_drop || (strcmp(order->words, "estop pull") == 0);
    order->is_of_page = is_drop || (strcmp(value, "hold") == 0);
}

box_order_verdict_t box_order_write(const request_box_order_t *request, box_order_t *order)
{
    const request_field_t *const field = next_reported(request_box_order.fields, request);
    if (field == NULL) {
        return refuse(order, request_box_order.fields[0].name, BOX_ORDER_MISSING);
    }
    const request_field_t *const another = next_reported(field + 1, request);
    if (another != NULL) {
        return refuse(order, another->name, BOX_ORDER_EXCESS);
    }
    if (needs_slot(field) != request->has_slot) {
        return refuse(order, "slot", request->has_slot ? BOX_ORDER_EXCESS : BOX_ORDER_MISSING);
    }
    write_words(field, request, order);
    return BOX_ORDER_WRITTEN;
}

const char *box_order_word(const char *member, uint32_t value)
{
    const request_field_t *field = request_box_order.fields;
    while (strcmp(field->name, member) != 0) {
        field++;
    }
    return field->words[(value < field->word_count) ? value : 0U].word;
}
