// SPDX-License-Identifier: Apache-2.0
//
// Compares our OpenIGTLink codec with the standard's own library (libOpenIGTLink 1.11), both ways:
// what we write the library must unpack to the same values with a right checksum, and what the
// library packs we must read; where both write the same message, the bytes must be equal. Ends with
// status 1 and a sentence at the first difference.

extern "C" {
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_packet.h"
}

#include <igtlCapabilityMessage.h>
#include <igtlMessageHeader.h>
#include <igtlNDArrayMessage.h>
#include <igtlPointMessage.h>
#include <igtlSensorMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTrajectoryMessage.h>
#include <igtlTransformMessage.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace
{

const int kRounds = 2000;
std::mt19937 generator(20130612);
int compared = 0;

void Check(bool is_equal, const char *what)
{
    compared++;
    if (!is_equal) {
        std::fprintf(stderr, "codec_oracle: %s differs\n", what);
        std::exit(1);
    }
}

unsigned Random(unsigned below)
{
    return static_cast<unsigned>(generator() % below);
}

std::string Text(unsigned longest)
{
    std::string text;
    const unsigned length = Random(longest + 1);
    for (unsigned i = 0; i < length; i++) {
        text += static_cast<char>(0x20 + Random(0x5f));
    }
    return text;
}

float Finite()
{
    return std::ldexp(static_cast<float>(static_cast<int>(Random(2000001)) - 1000000),
                      static_cast<int>(Random(30)) - 20);
}

uint32_t Bits(float number)
{
    uint32_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

template <class Message> typename Message::Pointer Unpacked(const igtl_packet_t &packet)
{
    igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
    header->InitPack();
    std::memcpy(header->GetPackPointer(), packet.bytes, IGTL_HEADER_BYTES);
    header->Unpack();
    typename Message::Pointer message = Message::New();
    message->SetMessageHeader(header);
    message->AllocatePack();
    Check(message->GetPackBodySize() == static_cast<int>(packet.length - IGTL_HEADER_BYTES),
          "a body's length");
    std::memcpy(message->GetPackBodyPointer(), &packet.bytes[IGTL_HEADER_BYTES],
                packet.length - IGTL_HEADER_BYTES);
    Check((message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) != 0, "a checksum");
    return message;
}

igtl_message_t Decoded(igtl::MessageBase *message)
{
    const uint8_t *bytes = static_cast<const uint8_t *>(message->GetPackPointer());
    igtl_header_t header;
    igtl_message_t decoded;
    Check(igtl_decode_header(bytes, &header) == IGTL_OK, "a header");
    Check(header.body_bytes + IGTL_HEADER_BYTES == static_cast<uint64_t>(message->GetPackSize()),
          "a length");
    Check(igtl_decode_body(&header, &bytes[IGTL_HEADER_BYTES], &decoded) == IGTL_OK, "a body");
    Check(std::string(decoded.name) == message->GetDeviceName(), "a device name");
    return decoded;
}

// All but the time stamp, which the library sets.
void CheckBytes(igtl::MessageBase *message, const igtl_packet_t &packet)
{
    const uint8_t *bytes = static_cast<const uint8_t *>(message->GetPackPointer());
    Check(packet.length == static_cast<uint32_t>(message->GetPackSize()), "a message's length");
    Check(std::memcmp(bytes, packet.bytes, 34) == 0, "a header's beginning");
    Check(std::memcmp(&bytes[42], &packet.bytes[42], packet.length - 42) == 0, "a message's bytes");
}

void CompareString()
{
    const std::string name = Text(19);
    const std::string text = Text(IGTL_TEXT_MAX);
    igtl_packet_t packet;
    igtl_encode_string(&packet, name.c_str(), text.c_str(), 0);
    Check(std::string(Unpacked<igtl::StringMessage>(packet)->GetString()) == text, "a text");
    igtl::StringMessage::Pointer message = igtl::StringMessage::New();
    message->SetDeviceName(name.c_str());
    message->SetString(text.c_str());
    message->Pack();
    const igtl_message_t decoded = Decoded(message);
    Check(std::string(decoded.text, decoded.text_bytes) == text, "a text");
    CheckBytes(message, packet);
}

void CompareStatus()
{
    const std::string name = Text(19);
    const std::string error_name = Text(19);
    const std::string text = Text(IGTL_TEXT_MAX);
    const igtl_status_t status = {Random(20), error_name.c_str(), text.c_str()};
    igtl_packet_t packet;
    igtl_encode_status(&packet, name.c_str(), &status, 0);
    igtl::StatusMessage::Pointer unpacked = Unpacked<igtl::StatusMessage>(packet);
    Check(unpacked->GetCode() == static_cast<int>(status.code), "a code");
    Check(error_name == unpacked->GetErrorName(), "an error name");
    Check(text == unpacked->GetStatusString(), "a text");
    igtl::StatusMessage::Pointer message = igtl::StatusMessage::New();
    message->SetDeviceName(name.c_str());
    message->SetCode(static_cast<int>(status.code));
    message->SetSubCode(0);
    message->SetErrorName(error_name.c_str());
    message->SetStatusString(text.c_str());
    message->Pack();
    Check(Decoded(message).code == status.code, "a code");
    CheckBytes(message, packet);
}

void CompareTransform()
{
    const std::string name = Text(19);
    igtl::Matrix4x4 matrix = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}};
    igtl::Matrix4x4 back;
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];
    igtl_packet_t packet;
    for (int i = 0; i < 12; i++) {
        matrix[i % 3][i / 3] = Finite();
        numbers[i] = Bits(matrix[i % 3][i / 3]);
    }
    igtl_encode_transform(&packet, name.c_str(), numbers, 0);
    Unpacked<igtl::TransformMessage>(packet)->GetMatrix(back);
    Check(std::memcmp(matrix, back, sizeof matrix) == 0, "a matrix");
    igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
    message->SetDeviceName(name.c_str());
    message->SetMatrix(matrix);
    message->Pack();
    const igtl_message_t decoded = Decoded(message);
    Check(std::memcmp(decoded.numbers, numbers, sizeof numbers) == 0, "a matrix");
    CheckBytes(message, packet);
}

void ComparePoint()
{
    const std::string name = Text(19);
    igtlFloat32 position[3] = {Finite(), Finite(), Finite()};
    const uint32_t numbers[3] = {Bits(position[0]), Bits(position[1]), Bits(position[2])};
    igtl_packet_t packet;
    igtl_encode_point(&packet, name.c_str(), numbers, 0);
    igtl::PointElement::Pointer point;
    igtlFloat32 back[3];
    Unpacked<igtl::PointMessage>(packet)->GetPointElement(0, point);
    point->GetPosition(back);
    Check(std::memcmp(position, back, sizeof back) == 0, "a point");
    Check(name == point->GetName(), "a point's name");
    igtl::PointMessage::Pointer message = igtl::PointMessage::New();
    point = igtl::PointElement::New();
    point->SetName(name.c_str());
    point->SetGroupName("");
    point->SetRGBA(255, 255, 255, 255);
    point->SetPosition(position);
    point->SetRadius(0);
    point->SetOwner("");
    message->SetDeviceName(name.c_str());
    message->AddPointElement(point);
    message->Pack();
    Check(Decoded(message).kind == IGTL_KIND_POINT, "a point list");
    CheckBytes(message, packet);
}

void CompareCapability()
{
    const std::string name = Text(19);
    const unsigned count = Random(IGTL_CAPABILITIES_MAX + 1);
    std::vector<std::string> types;
    std::vector<const char *> pointers(IGTL_CAPABILITIES_MAX);
    igtl_packet_t packet;
    for (unsigned i = 0; i < count; i++) {
        types.push_back("T" + Text(11));
    }
    for (unsigned i = 0; i < count; i++) {
        pointers[i] = types[i].c_str();
    }
    igtl_encode_capability(&packet, name.c_str(), pointers.data(), count, 0);
    igtl::CapabilityMessage::Pointer message = igtl::CapabilityMessage::New();
    message->SetDeviceName(name.c_str());
    message->SetTypes(types);
    message->Pack();
    CheckBytes(message, packet);
    if (count > 0) {
        Check(Unpacked<igtl::CapabilityMessage>(packet)->GetTypes() == types, "a list of types");
    }
}

void CompareTracking()
{
    const std::string name = Text(19);
    const unsigned count = 1 + Random(IGTL_TRACKED_MAX);
    std::vector<std::string> names;
    igtl_tracked_t elements[IGTL_TRACKED_MAX];
    igtl_packet_t packet;
    igtl::TrackingDataMessage::Pointer message = igtl::TrackingDataMessage::New();
    message->SetDeviceName(name.c_str());
    for (unsigned i = 0; i < count; i++) {
        names.push_back(Text(19));
    }
    for (unsigned i = 0; i < count; i++) {
        igtl::Matrix4x4 matrix = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}};
        igtl::TrackingDataElement::Pointer element = igtl::TrackingDataElement::New();
        elements[i].name = names[i].c_str();
        for (int k = 0; k < 12; k++) {
            matrix[k % 3][k / 3] = Finite();
            elements[i].numbers[k] = Bits(matrix[k % 3][k / 3]);
        }
        element->SetName(names[i].c_str());
        element->SetType(igtl::TrackingDataElement::TYPE_6D);
        element->SetMatrix(matrix);
        message->AddTrackingDataElement(element);
    }
    message->Pack();
    igtl_encode_tracking(&packet, name.c_str(), elements, count, 0);
    // The library leaves a reserved byte of each instrument as its memory was.
    uint8_t *body = static_cast<uint8_t *>(message->GetPackBodyPointer());
    for (unsigned i = 0; i < count; i++) {
        body[70 * i + 21] = 0;
    }
    Check(message->GetPackSize() == static_cast<int>(packet.length), "a message's length");
    Check(std::memcmp(body, &packet.bytes[IGTL_HEADER_BYTES], packet.length - IGTL_HEADER_BYTES) ==
              0,
          "a TDATA");
    igtl::TrackingDataMessage::Pointer unpacked = Unpacked<igtl::TrackingDataMessage>(packet);
    Check(unpacked->GetNumberOfTrackingDataElements() == static_cast<int>(count),
          "a number of instruments");
    for (unsigned i = 0; i < count; i++) {
        igtl::TrackingDataElement::Pointer element;
        igtl::Matrix4x4 matrix;
        unpacked->GetTrackingDataElement(static_cast<int>(i), element);
        element->GetMatrix(matrix);
        Check(names[i] == element->GetName(), "an instrument's name");
        Check(element->GetType() == igtl::TrackingDataElement::TYPE_6D, "an instrument's type");
        Check(Bits(matrix[2][3]) == elements[i].numbers[11], "an instrument's matrix");
    }
}

void CompareForce()
{
    const std::string name = Text(19);
    const double newtons = static_cast<double>(Finite()) / 3;
    uint64_t bits;
    igtl_packet_t packet;
    igtl::Unit::Pointer newton = igtl::Unit::New();
    newton->Init();
    newton->Append(igtl::Unit::SI_DERIVED_NEWTON, 1);
    std::memcpy(&bits, &newtons, sizeof bits);
    igtl_encode_force(&packet, name.c_str(), bits, 0);
    igtl::SensorMessage::Pointer unpacked = Unpacked<igtl::SensorMessage>(packet);
    Check(unpacked->GetLength() == 1, "a number of values");
    Check(unpacked->GetUnit() == newton->Pack(), "a unit");
    const double back = unpacked->GetValue(0);
    Check(std::memcmp(&back, &newtons, sizeof back) == 0, "a force");
    igtl::SensorMessage::Pointer message = igtl::SensorMessage::New();
    message->SetDeviceName(name.c_str());
    message->SetLength(1);
    message->SetUnit(newton);
    message->SetValue(0, newtons);
    message->Pack();
    CheckBytes(message, packet);
}

void CompareTrajectory()
{
    const std::string name = Text(19);
    const unsigned type = 1 + Random(3);
    igtlFloat32 entry[3] = {Finite(), Finite(), Finite()};
    igtlFloat32 target[3] = {Finite(), Finite(), Finite()};
    igtl::TrajectoryElement::Pointer element = igtl::TrajectoryElement::New();
    element->SetName(Text(63).c_str());
    element->SetGroupName(Text(31).c_str());
    element->SetType(static_cast<igtlUint8>(type));
    element->SetRGBA(255, 255, 0, 255);
    element->SetEntryPosition(entry);
    element->SetTargetPosition(target);
    element->SetRadius(Finite());
    element->SetOwner(Text(19).c_str());
    igtl::TrajectoryMessage::Pointer message = igtl::TrajectoryMessage::New();
    message->SetDeviceName(name.c_str());
    message->AddTrajectoryElement(element);
    message->Pack();
    const igtl_message_t decoded = Decoded(message);
    Check(decoded.kind == IGTL_KIND_TRAJECTORY, "a trajectory");
    Check(decoded.code == type, "what a trajectory has");
    for (int i = 0; i < 3; i++) {
        Check(decoded.numbers[i] == Bits(entry[i]), "an entry");
        Check(decoded.numbers[3 + i] == Bits(target[i]), "a target");
    }
}

template <class Number> void CompareArray(int type)
{
    const igtlUint16 rows = static_cast<igtlUint16>(1 + Random(8));
    const igtlUint16 columns = static_cast<igtlUint16>(1 + Random(15));
    std::vector<Number> numbers;
    for (unsigned i = 0; i < rows * static_cast<unsigned>(columns); i++) {
        numbers.push_back(static_cast<Number>(Finite()) / 3);
    }
    igtl::Array<Number> array;
    array.SetSize({rows, columns});
    array.SetArray(numbers.data());
    igtl::NDArrayMessage::Pointer message = igtl::NDArrayMessage::New();
    message->SetDeviceName("TRAJECTORY");
    message->SetArray(type, &array);
    message->Pack();
    const igtl_message_t decoded = Decoded(message);
    Check(decoded.kind == IGTL_KIND_ARRAY && decoded.rows == rows && decoded.columns == columns,
          "an array's shape");
    Check(decoded.number_bytes == sizeof(Number), "an array's type");
    for (unsigned i = 0; i < numbers.size(); i++) {
        uint64_t bits = 0;
        std::memcpy(&bits, &numbers[i], sizeof(Number));
        Check(igtl_array_bits(&decoded, i) == bits, "a number of an array");
    }
}

void CompareStreams()
{
    const std::string name = Text(19);
    const std::string coordinates = Text(31);
    const int resolution = static_cast<int>(Random(2000)) - 1000;
    igtl_packet_t packet;
    igtl::StartTrackingDataMessage::Pointer start = igtl::StartTrackingDataMessage::New();
    start->SetDeviceName(name.c_str());
    start->SetResolution(resolution);
    start->SetCoordinateName(coordinates.c_str());
    start->Pack();
    const igtl_message_t begun = Decoded(start);
    Check(begun.kind == IGTL_KIND_STT_TDATA, "STT_TDATA");
    Check(begun.resolution_ms == resolution, "a resolution");
    Check(std::string(begun.subject, begun.subject_bytes) == coordinates, "a coordinate system");
    igtl::StopTrackingDataMessage::Pointer stop = igtl::StopTrackingDataMessage::New();
    stop->SetDeviceName(name.c_str());
    stop->Pack();
    Check(Decoded(stop).kind == IGTL_KIND_STP_TDATA, "STP_TDATA");
    igtl_encode_empty(&packet, "STP_TDATA", name.c_str(), 0);
    CheckBytes(stop, packet);
    igtl::RTSTrackingDataMessage::Pointer returned = igtl::RTSTrackingDataMessage::New();
    const bool is_refused = Random(2) == 1;
    returned->SetDeviceName(name.c_str());
    returned->SetStatus(is_refused ? igtl::RTSTrackingDataMessage::STATUS_ERROR
                                   : igtl::RTSTrackingDataMessage::STATUS_SUCCESS);
    returned->Pack();
    igtl_encode_return(&packet, "RTS_TDATA", name.c_str(), is_refused, 0);
    CheckBytes(returned, packet);
}

template <class Query> void CompareQuery(igtl_kind_t kind, const char *type)
{
    const std::string name = Text(19);
    igtl_packet_t packet;
    typename Query::Pointer query = Query::New();
    query->SetDeviceName(name.c_str());
    query->Pack();
    Check(Decoded(query).kind == kind, type);
    igtl_encode_empty(&packet, type, name.c_str(), 0);
    CheckBytes(query, packet);
}

} // namespace

int main()
{
    for (int i = 0; i < kRounds; i++) {
        CompareString();
        CompareStatus();
        CompareTransform();
        ComparePoint();
        CompareCapability();
        CompareTracking();
        CompareForce();
        CompareTrajectory();
        CompareArray<igtlFloat32>(igtl::NDArrayMessage::TYPE_FLOAT32);
        CompareArray<igtlFloat64>(igtl::NDArrayMessage::TYPE_FLOAT64);
        CompareStreams();
    }
    CompareQuery<igtl::GetTransformMessage>(IGTL_KIND_GET_TRANSFORM, "GET_TRANS");
    CompareQuery<igtl::GetStatusMessage>(IGTL_KIND_GET_STATUS, "GET_STATUS");
    CompareQuery<igtl::GetPointMessage>(IGTL_KIND_GET_POINT, "GET_POINT");
    CompareQuery<igtl::GetCapabilityMessage>(IGTL_KIND_GET_CAPABILITY, "GET_CAPABIL");
    std::printf("codec_oracle: %d comparisons with libOpenIGTLink, no difference\n", compared);
    return 0;
}
