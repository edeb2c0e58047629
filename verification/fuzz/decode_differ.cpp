// SPDX-License-Identifier: Apache-2.0
//
// Messages of the standard's own library (libOpenIGTLink 1.11), damaged by chance: whatever our
// codec accepts, the library must read to the same values. It does not survive what is malformed,
// so only what we accept is handed to it, of header version 2 the content as version 1. Ends with
// status 1 and a sentence at the first difference.

extern "C" {
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/igtl_packet.h"
}

#include <igtlCapabilityMessage.h>
#include <igtlMessageHeader.h>
#include <igtlPointMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTrajectoryMessage.h>
#include <igtlTransformMessage.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{

typedef std::vector<uint8_t> Bytes;

const unsigned kRounds = 150000;
const uint32_t kBodyMax = 4096; // igtl_body_max
std::mt19937 generator(19640);
std::map<std::string, unsigned> accepted;
unsigned refused = 0;

void Check(bool is_equal, const char *what)
{
    if (!is_equal) {
        std::fprintf(stderr, "decode_differ: %s differs\n", what);
        std::exit(1);
    }
}

unsigned Random(unsigned below)
{
    return static_cast<unsigned>(generator() % below);
}

float Number()
{
    const uint32_t bits = static_cast<uint32_t>(generator());
    float number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
}

std::string Text(unsigned longest)
{
    std::string text;
    for (unsigned i = Random(longest + 1); i > 0; i--) {
        text += static_cast<char>(0x20 + Random(0x5f));
    }
    return text;
}

void Put(Bytes &bytes, size_t at, uint64_t value, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        bytes[at + i] = static_cast<uint8_t>(value >> (8 * (count - 1 - i)));
    }
}

void Seal(Bytes &bytes)
{
    Put(bytes, 42, bytes.size() - IGTL_HEADER_BYTES, 8);
    Put(bytes, 50,
        igtl_crc64(0, bytes.data() + IGTL_HEADER_BYTES, bytes.size() - IGTL_HEADER_BYTES), 8);
}

Bytes Packed(igtl::MessageBase *message)
{
    message->SetDeviceName(Text(19).c_str());
    message->Pack();
    const uint8_t *bytes = static_cast<const uint8_t *>(message->GetPackPointer());
    return Bytes(bytes, bytes + message->GetPackSize());
}

Bytes Transform()
{
    igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
    igtl::Matrix4x4 matrix = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}};
    for (int i = 0; i < 12; i++) {
        matrix[i % 3][i / 3] = Number();
    }
    message->SetMatrix(matrix);
    return Packed(message);
}

Bytes String()
{
    igtl::StringMessage::Pointer message = igtl::StringMessage::New();
    message->SetEncoding(Random(2) ? 3 : 106);
    message->SetString(Text(600).c_str());
    return Packed(message);
}

Bytes Status()
{
    igtl::StatusMessage::Pointer message = igtl::StatusMessage::New();
    message->SetCode(static_cast<int>(Random(30)));
    message->SetSubCode(Random(1000));
    message->SetErrorName(Text(19).c_str());
    message->SetStatusString(Text(200).c_str());
    return Packed(message);
}

Bytes Points()
{
    igtl::PointMessage::Pointer message = igtl::PointMessage::New();
    for (unsigned i = Random(4) + 1; i > 0; i--) {
        igtl::PointElement::Pointer point = igtl::PointElement::New();
        point->SetName(Text(60).c_str());
        point->SetGroupName(Text(30).c_str());
        point->SetPosition(Number(), Number(), Number());
        point->SetOwner(Text(19).c_str());
        message->AddPointElement(point);
    }
    return Packed(message);
}

Bytes Trajectories()
{
    igtl::TrajectoryMessage::Pointer message = igtl::TrajectoryMessage::New();
    for (unsigned i = Random(8) == 0 ? 2 : 1; i > 0; i--) {
        igtl::TrajectoryElement::Pointer element = igtl::TrajectoryElement::New();
        element->SetName(Text(60).c_str());
        element->SetType(static_cast<igtlUint8>(1 + Random(3)));
        element->SetEntryPosition(Number(), Number(), Number());
        element->SetTargetPosition(Number(), Number(), Number());
        message->AddTrajectoryElement(element);
    }
    return Packed(message);
}

Bytes Start()
{
    igtl::StartTrackingDataMessage::Pointer message = igtl::StartTrackingDataMessage::New();
    message->SetResolution(static_cast<igtlInt32>(generator()));
    message->SetCoordinateName(Text(31).c_str());
    return Packed(message);
}

template <class Message> Bytes Empty()
{
    typename Message::Pointer message = Message::New();
    return Packed(message);
}

Bytes Some()
{
    switch (Random(10)) {
    case 0:
        return Transform();
    case 1:
        return String();
    case 2:
        return Status();
    case 3:
        return Points();
    case 4:
        return Start();
    case 5:
        return Empty<igtl::StopTrackingDataMessage>();
    case 6:
        return Empty<igtl::GetTransformMessage>();
    case 7:
        return Empty<igtl::GetStatusMessage>();
    case 8:
        return Trajectories();
    default:
        return Empty<igtl::GetCapabilityMessage>();
    }
}

// The same with an extended header and one entry of metadata.
Bytes Extended(const Bytes &message)
{
    static const uint8_t around[] = {0, 12, 0, 10, 0, 0, 0, 4, 0, 0, 0, 1};
    static const uint8_t metadata[] = {0, 1, 0, 2, 0, 3, 0, 0, 0, 2, 'k', 'k', 'v', 'v'};
    Bytes bytes(message.begin(), message.begin() + IGTL_HEADER_BYTES);
    bytes.insert(bytes.end(), around, around + sizeof around);
    bytes.insert(bytes.end(), message.begin() + IGTL_HEADER_BYTES, message.end());
    bytes.insert(bytes.end(), metadata, metadata + sizeof metadata);
    Put(bytes, 0, 2, 2);
    return bytes;
}

// Most checksums are right, or nothing else would be looked at.
void Damage(Bytes &bytes)
{
    for (unsigned i = Random(3); i > 0; i--) {
        bytes[Random(static_cast<unsigned>(bytes.size()))] = static_cast<uint8_t>(Random(256));
    }
    if (Random(8) == 0) {
        bytes.resize(IGTL_HEADER_BYTES +
                     Random(static_cast<unsigned>(bytes.size() - IGTL_HEADER_BYTES) + 20));
    }
    if (Random(16) != 0) {
        Seal(bytes);
    }
}

// Result of the library for the content.
template <class Message> typename Message::Pointer Read(const Bytes &plain)
{
    igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
    header->InitPack();
    std::memcpy(header->GetPackPointer(), plain.data(), IGTL_HEADER_BYTES);
    header->Unpack();
    typename Message::Pointer message = Message::New();
    message->SetMessageHeader(header);
    message->AllocatePack();
    Check(message->GetPackBodySize() == static_cast<int>(plain.size() - IGTL_HEADER_BYTES),
          "a body's length");
    std::memcpy(message->GetPackBodyPointer(), plain.data() + IGTL_HEADER_BYTES,
                plain.size() - IGTL_HEADER_BYTES);
    Check((message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) != 0, "a checksum");
    return message;
}

uint32_t Bits(float number)
{
    uint32_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

uint32_t BitsAt(const uint8_t *bytes)
{
    return static_cast<uint32_t>(bytes[0]) << 24 | static_cast<uint32_t>(bytes[1]) << 16 |
           static_cast<uint32_t>(bytes[2]) << 8 | bytes[3];
}

void CompareTransform(const igtl_message_t &ours, const Bytes &plain)
{
    igtl::Matrix4x4 matrix;
    Read<igtl::TransformMessage>(plain)->GetMatrix(matrix);
    for (unsigned i = 0; i < 12; i++) {
        Check(Bits(matrix[i % 3][i / 3]) == ours.numbers[i], "a matrix");
    }
}

void CompareString(const igtl_message_t &ours, const Bytes &plain)
{
    Check(std::string(ours.text, ours.text_bytes) == Read<igtl::StringMessage>(plain)->GetString(),
          "a text");
}

void CompareStatus(const igtl_message_t &ours, const Bytes &plain)
{
    Check(static_cast<int>(ours.code) == Read<igtl::StatusMessage>(plain)->GetCode(), "a code");
}

void ComparePoints(const igtl_message_t &ours, const Bytes &plain)
{
    if (ours.content_bytes == 0) {
        return; // The library has no list without a point.
    }
    igtl::PointMessage::Pointer theirs = Read<igtl::PointMessage>(plain);
    Check(theirs->GetNumberOfPointElement() ==
              static_cast<int>(ours.content_bytes / IGTL_POINT_BYTES),
          "a number of points");
    for (int i = 0; i < theirs->GetNumberOfPointElement(); i++) {
        igtl::PointElement::Pointer point;
        igtlFloat32 position[3];
        theirs->GetPointElement(i, point);
        point->GetPosition(position);
        for (int k = 0; k < 3; k++) {
            Check(Bits(position[k]) == BitsAt(ours.content + i * IGTL_POINT_BYTES + 100 + 4 * k),
                  "a point");
        }
    }
}

void CompareTrajectory(const igtl_message_t &ours, const Bytes &plain)
{
    igtl::TrajectoryMessage::Pointer theirs = Read<igtl::TrajectoryMessage>(plain);
    igtl::TrajectoryElement::Pointer element;
    igtlFloat32 entry[3];
    igtlFloat32 target[3];
    Check(theirs->GetNumberOfTrajectoryElement() == 1, "a number of trajectories");
    theirs->GetTrajectoryElement(0, element);
    element->GetEntryPosition(entry);
    element->GetTargetPosition(target);
    Check(element->GetType() == static_cast<igtlUint8>(ours.code), "what a trajectory has");
    for (unsigned i = 0; i < 3; i++) {
        Check(Bits(entry[i]) == ours.numbers[i] && Bits(target[i]) == ours.numbers[3 + i],
              "a trajectory");
    }
}

void CompareStart(const igtl_message_t &ours, const Bytes &plain)
{
    igtl::StartTrackingDataMessage::Pointer theirs = Read<igtl::StartTrackingDataMessage>(plain);
    Check(theirs->GetResolution() == ours.resolution_ms, "a resolution");
    if (ours.subject_bytes < 32) { // The library leaves out one that fills its field.
        Check(std::string(ours.subject, ours.subject_bytes) == theirs->GetCoordinateName(),
              "a coordinate system");
    }
}

void CompareContent(const igtl_message_t &ours, const Bytes &plain)
{
    switch (ours.kind) {
    case IGTL_KIND_TRANSFORM:
        CompareTransform(ours, plain);
        break;
    case IGTL_KIND_STRING:
        CompareString(ours, plain);
        break;
    case IGTL_KIND_STATUS:
        CompareStatus(ours, plain);
        break;
    case IGTL_KIND_POINT:
        ComparePoints(ours, plain);
        break;
    case IGTL_KIND_STT_TDATA:
        CompareStart(ours, plain);
        break;
    case IGTL_KIND_TRAJECTORY:
        CompareTrajectory(ours, plain);
        break;
    default:
        break;
    }
}

void CompareHeader(const igtl_message_t &ours, const Bytes &plain)
{
    igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
    header->InitPack();
    std::memcpy(header->GetPackPointer(), plain.data(), IGTL_HEADER_BYTES);
    header->Unpack();
    Check(std::string(ours.type) == header->GetDeviceType(), "a type");
    Check(std::string(ours.name) == header->GetDeviceName(), "a name");
    Check(static_cast<int>(ours.content_bytes) == header->GetBodySizeToRead(), "a length");
}

void Compare(const Bytes &bytes)
{
    igtl_header_t header;
    igtl_message_t ours;
    const bool is_read =
        igtl_decode_header(bytes.data(), &header) == IGTL_OK && header.kind != IGTL_KIND_OTHER &&
        header.body_bytes <= kBodyMax && header.body_bytes == bytes.size() - IGTL_HEADER_BYTES &&
        igtl_decode_body(&header, bytes.data() + IGTL_HEADER_BYTES, &ours) == IGTL_OK;
    if (!is_read) {
        refused++;
        return;
    }
    const bool is_named = header.kind != IGTL_KIND_GET_OTHER &&
                          header.kind != IGTL_KIND_STT_OTHER && header.kind != IGTL_KIND_STP_OTHER;
    accepted[is_named ? header.type : "others"]++;
    Bytes plain(bytes.begin(), bytes.begin() + IGTL_HEADER_BYTES);
    plain.insert(plain.end(), ours.content, ours.content + ours.content_bytes);
    Put(plain, 0, 1, 2);
    Seal(plain);
    CompareHeader(ours, plain);
    CompareContent(ours, plain);
}

Bytes Written(const igtl_packet_t &packet)
{
    return Bytes(packet.bytes, packet.bytes + packet.length);
}

// Messages that we answer with and never read.
void CompareAnswers()
{
    static const char *const types[] = {"TRANSFORM", "STRING", "GET_CAPABIL"};
    igtl_packet_t packet;
    igtl_tracked_t tracked = {"needle", {0}};
    igtl::TrackingDataElement::Pointer element;
    igtl::Matrix4x4 matrix;
    for (unsigned i = 0; i < 12; i++) {
        tracked.numbers[i] = Bits(Number());
    }
    igtl_encode_tracking(&packet, "name", &tracked, 1, 0);
    igtl::TrackingDataMessage::Pointer tracking = Read<igtl::TrackingDataMessage>(Written(packet));
    Check(tracking->GetNumberOfTrackingDataElements() == 1, "a number of instruments");
    tracking->GetTrackingDataElement(0, element);
    element->GetMatrix(matrix);
    Check(std::string("needle") == element->GetName(), "an instrument's name");
    for (unsigned i = 0; i < 12; i++) {
        Check(Bits(matrix[i % 3][i / 3]) == tracked.numbers[i], "an instrument");
    }
    igtl_encode_capability(&packet, "", types, 3, 0);
    igtl::CapabilityMessage::Pointer capability = Read<igtl::CapabilityMessage>(Written(packet));
    Check(capability->GetNumberOfTypes() == 3, "a number of types");
    for (int i = 0; i < 3; i++) {
        Check(std::string(types[i]) == capability->GetType(i), "a type that is named");
    }
    igtl_encode_return(&packet, "RTS_TDATA", "name", true, 0);
    Check(Read<igtl::RTSTrackingDataMessage>(Written(packet))->GetStatus() != 0, "a refusal");
}

} // namespace

int main()
{
    for (unsigned i = 0; i < kRounds; i++) {
        Bytes bytes = Some();
        if (Random(4) == 0) {
            bytes = Extended(bytes);
        }
        Damage(bytes);
        Compare(bytes);
    }
    for (unsigned i = 0; i < 1000; i++) {
        CompareAnswers();
    }
    std::printf("decode_differ: of %u messages %u refused;", kRounds, refused);
    for (const auto &type : accepted) {
        std::printf(" %s %u", type.first.c_str(), type.second);
    }
    std::printf(": no difference\n");
    return 0;
}
