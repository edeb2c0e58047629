// SPDX-License-Identifier: Apache-2.0
//
// Our OpenIGTLink codec beside the standard's own library (libOpenIGTLink 1.11): a TRANSFORM from a
// matrix to bytes and back. The library's objects are kept from message to message, or made anew
// for each.
//
//   bench-codec ROUNDS CALLS     ROUNDS times in turn CALLS of each way
//
// Prints for each way its name and its ns per call, the median of the rounds. Before that it
// compares what all ways write and read, and ends with status 1 when anything differs. Each way is
// one function with its name, so that callgrind can count it.

extern "C" {
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_packet.h"
}

#include <igtlMessageHeader.h>
#include <igtlTransformMessage.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#define WAY extern "C" __attribute__((noinline)) void

namespace
{

const char kName[] = "CURRENT_POSITION";
const unsigned kSeconds = 1700000000;
const unsigned kFraction = 0x40000000;
const size_t kLength = IGTL_HEADER_BYTES + IGTL_TRANSFORM_BYTES;

igtl::Matrix4x4 to_send = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}};
igtl::Matrix4x4 received;
uint8_t to_read[kLength];
igtl_packet_t packet;
igtl::TransformMessage::Pointer kept_sender;
igtl::TransformMessage::Pointer kept_reader;
igtl::MessageHeader::Pointer kept_header;
const void *sent;

void Pack(igtl::TransformMessage *message)
{
    message->SetMatrix(to_send);
    message->SetTimeStamp(kSeconds, kFraction);
    message->Pack();
    sent = message->GetPackPointer();
}

void Unpack(igtl::MessageHeader::Pointer header, igtl::TransformMessage *message)
{
    header->InitPack();
    std::memcpy(header->GetPackPointer(), to_read, IGTL_HEADER_BYTES);
    header->Unpack();
    message->SetMessageHeader(header);
    message->AllocatePack();
    std::memcpy(message->GetPackBodyPointer(), &to_read[IGTL_HEADER_BYTES], IGTL_TRANSFORM_BYTES);
    if ((message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) == 0) {
        std::abort();
    }
    message->GetMatrix(received);
}

} // namespace

WAY pack_ours()
{
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];
    for (int i = 0; i < 4; i++) {
        std::memcpy(&numbers[3 * i], &to_send[0][i], sizeof numbers[0]);
        std::memcpy(&numbers[3 * i + 1], &to_send[1][i], sizeof numbers[0]);
        std::memcpy(&numbers[3 * i + 2], &to_send[2][i], sizeof numbers[0]);
    }
    igtl_encode_transform(&packet, kName, numbers,
                          (static_cast<uint64_t>(kSeconds) << 32) | kFraction);
    sent = packet.bytes;
}

WAY pack_kept()
{
    Pack(kept_sender);
}

WAY pack_new()
{
    igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
    message->SetDeviceName(kName);
    Pack(message);
    std::memcpy(packet.bytes, sent, kLength); // It ends with the object.
    sent = packet.bytes;
}

WAY unpack_ours()
{
    igtl_header_t header;
    igtl_message_t message;
    if ((igtl_decode_header(to_read, &header) != IGTL_OK) ||
        (igtl_decode_body(&header, &to_read[IGTL_HEADER_BYTES], &message) != IGTL_OK)) {
        std::abort();
    }
    for (int i = 0; i < 4; i++) {
        std::memcpy(&received[0][i], &message.numbers[3 * i], sizeof message.numbers[0]);
        std::memcpy(&received[1][i], &message.numbers[3 * i + 1], sizeof message.numbers[0]);
        std::memcpy(&received[2][i], &message.numbers[3 * i + 2], sizeof message.numbers[0]);
    }
}

WAY unpack_kept()
{
    Unpack(kept_header, kept_reader);
}

WAY unpack_new()
{
    Unpack(igtl::MessageHeader::New(), igtl::TransformMessage::New());
}

namespace
{

struct Way {
    const char *name;
    void (*run)();
    std::vector<double> times_ns;
};

void Differ(const Way &way)
{
    std::fprintf(stderr, "bench-codec: %s differs\n", way.name);
    std::exit(1);
}

void Compare(const std::vector<Way> &packing, const std::vector<Way> &unpacking)
{
    for (int i = 0; i < 12; i++) {
        to_send[i % 3][i / 3] = 0.37f * static_cast<float>(i) - 1.9f;
    }
    std::memset(to_read, 0, sizeof to_read);
    for (const Way &way : packing) {
        way.run();
        if (&way == &packing.front()) {
            std::memcpy(to_read, sent, kLength);
        }
        if (std::memcmp(to_read, sent, kLength) != 0) {
            Differ(way);
        }
    }
    for (const Way &way : unpacking) {
        std::memset(received, 0, sizeof received);
        received[3][3] = 1;
        way.run();
        if (std::memcmp(received, to_send, sizeof received) != 0) {
            Differ(way);
        }
    }
}

void Time(Way &way, int calls)
{
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < calls; i++) {
        to_send[0][3] = static_cast<float>(i);
        way.run();
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
    way.times_ns.push_back(taken.count() / calls);
}

double Median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

int main(int count, char **words)
{
    const int rounds = (count == 3) ? std::atoi(words[1]) : 0;
    const int calls = (count == 3) ? std::atoi(words[2]) : 0;
    if ((rounds < 1) || (calls < 1)) {
        std::fprintf(stderr, "usage: bench-codec ROUNDS CALLS\n");
        return 2;
    }
    std::vector<Way> packing = {
        {"pack_ours", pack_ours, {}}, {"pack_kept", pack_kept, {}}, {"pack_new", pack_new, {}}};
    std::vector<Way> unpacking = {{"unpack_ours", unpack_ours, {}},
                                  {"unpack_kept", unpack_kept, {}},
                                  {"unpack_new", unpack_new, {}}};
    kept_sender = igtl::TransformMessage::New();
    kept_sender->SetDeviceName(kName);
    kept_reader = igtl::TransformMessage::New();
    kept_header = igtl::MessageHeader::New();
    Compare(packing, unpacking);
    for (int round = 0; round < rounds; round++) {
        for (size_t i = 0; i < packing.size(); i++) {
            Time(packing[i], calls);
            Time(unpacking[i], calls);
        }
    }
    for (const std::vector<Way> *ways : {&packing, &unpacking}) {
        for (const Way &way : *ways) {
            std::printf("%s %.1f\n", way.name, Median(way.times_ns));
        }
    }
    return 0;
}
