// SPDX-License-Identifier: Apache-2.0
//
// A client of the OpenIGTLink server, for tests and for the demonstration. Headers, checksums and
// messages are those of the standard's own library (libOpenIGTLink 1.11); of our code only the
// command line is in it.
//
//   boresight-client [--host 127.0.0.1] [--port 18936] ["phase START_UP" "wait STATUS START_UP
//   30000" ...]
//
// Without commands they are read from the standard input, one a line. Everything that arrives is
// printed as one line of JSON; each command ends with a line {"done": ...}. A command that fails
// ends the client with status 1 and a sentence. Matrices are 12 numbers, row by row (r11 r12 r13 tx
// ... tz), or all 16.

#include <igtlCapabilityMessage.h>
#include <igtlClientSocket.h>
#include <igtlMessageHeader.h>
#include <igtlNDArrayMessage.h>
#include <igtlPointMessage.h>
#include <igtlSensorMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTrajectoryMessage.h>
#include <igtlTransformMessage.h>

extern "C" {
#include "common/command_line.h"
}

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <poll.h>
#include <unistd.h>

namespace
{

// A bound against hanging, where none is given.
const int kTimeoutMs = 120000;

typedef std::chrono::steady_clock Clock;
typedef std::vector<std::string> Words;

// The library hides its descriptor from all but heirs; poll() needs it.
class Channel : public igtl::ClientSocket
{
  public:
    typedef igtl::SmartPointer<Channel> Pointer;
    static Pointer New()
    {
        Pointer channel = new Channel;
        channel->UnRegister();
        return channel;
    }
    int Descriptor() const
    {
        return m_SocketDescriptor;
    }
};

// A message without content, of any type.
class Question : public igtl::HeaderOnlyMessageBase
{
  public:
    typedef igtl::SmartPointer<Question> Pointer;
    static Pointer New(const std::string &type)
    {
        Pointer question = new Question;
        question->UnRegister();
        question->m_DefaultBodyType = type;
        return question;
    }
};

struct Received {
    std::string type;
    std::string name;
    int code;
    std::string text;
    std::vector<float> numbers;
    double t_ms;
};

std::string Quote(const std::string &text)
{
    std::string quoted = "\"";
    for (std::string::size_type i = 0; i < text.size(); i++) {
        const unsigned char byte = static_cast<unsigned char>(text[i]);
        if (byte == '"' || byte == '\\') {
            quoted += '\\';
            quoted += text[i];
        } else if (byte < 0x20 || byte > 0x7e) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", byte);
            quoted += escape;
        } else {
            quoted += text[i];
        }
    }
    return quoted + "\"";
}

std::string Number(double value)
{
    char text[40];
    if (!std::isfinite(value)) {
        return "null";
    }
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

class Client
{
  public:
    Client() : start_(Clock::now()), cursor_(0), next_id_(1)
    {
    }

    void Connect(const std::string &host, int port)
    {
        channel_ = Channel::New();
        if (channel_->ConnectToServer(host.c_str(), port) != 0) {
            std::ostringstream message;
            message << "nothing listens on " << host << " port " << port
                    << "; start boresight first";
            throw std::runtime_error(message.str());
        }
        channel_->SetReceiveTimeout(kTimeoutMs);
    }

    void Run(const std::string &line)
    {
        std::istringstream input(line);
        Words words;
        std::string word;
        while (input >> word) {
            words.push_back(word);
        }
        if (words.empty() || words[0][0] == '#') {
            return;
        }
        Dispatch(words, line);
        std::cout << "{\"t_ms\":" << Number(Now()) << ",\"done\":" << Quote(line) << "}"
                  << std::endl;
    }

    // Prints what arrives until standard input has a line.
    void WaitForInput()
    {
        while (std::cin.rdbuf()->in_avail() <= 0) {
            pollfd polls[2] = {{STDIN_FILENO, POLLIN, 0}, {channel_->Descriptor(), POLLIN, 0}};
            const nfds_t count = channel_->GetConnected() ? 2 : 1;
            poll(polls, count, -1);
            if (count == 2 && polls[1].revents != 0 && !Receive()) {
                channel_->CloseSocket();
                std::cout << "{\"t_ms\":" << Number(Now()) << ",\"type\":\"CLOSED\"}" << std::endl;
            }
            if (polls[0].revents != 0) {
                return;
            }
        }
    }

  private:
    double Now() const
    {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }

    static void Need(const Words &words, std::size_t count, const char *usage)
    {
        if (words.size() < count) {
            throw std::runtime_error(std::string("usage: ") + usage);
        }
    }

    void Dispatch(const Words &words, const std::string &line)
    {
        const std::string &verb = words[0];
        if (verb == "phase") {
            Need(words, 2, "phase NAME [ID]");
            SendPhase(words[1], words.size() > 2 ? words[2] : NextId());
        } else if (verb == "registration") {
            SendPose("CLB_", words);
        } else if (verb == "target") {
            SendPose("TGT_", words);
        } else if (verb == "transform") {
            Need(words, 14, "transform NAME 12 or 16 numbers");
            Begin();
            SendTransform(words[1], words, 2);
        } else if (verb == "string") {
            Need(words, 2, "string NAME [TEXT]");
            Begin();
            SendString(words[1], After(line, 2));
        } else if (verb == "traj") {
            Need(words, 8, "traj NAME entry, target or both of each trajectory and its 6 numbers");
            SendTrajectories(words);
        } else if (verb == "array") {
            Need(words, 5, "array NAME 32 or 64 COLUMNS numbers, row by row");
            if (words[2] == "32") {
                SendArray<igtlFloat32>(words, igtl::NDArrayMessage::TYPE_FLOAT32);
            } else {
                SendArray<igtlFloat64>(words, igtl::NDArrayMessage::TYPE_FLOAT64);
            }
        } else if (verb == "wait") {
            Need(words, 3, "wait TYPE NAME [MS]");
            Await(words[1], words[2], TimeoutOf(words, 3));
        } else if (verb == "expect") {
            Need(words, 4, "expect STATUS NAME CODE [MS]");
            Expect(words);
        } else if (verb == "get") {
            Need(words, 2, "get NAME");
            Ask(words[1]);
        } else if (verb == "ask") {
            Need(words, 2, "ask TYPE [NAME]");
            AskFor(words[1], words.size() > 2 ? words[2] : "");
        } else if (verb == "track") {
            Need(words, 3, "track NAME MS");
            Track(words[1], std::atoi(words[2].c_str()));
        } else if (verb == "expect-silence") {
            Need(words, 2, "expect-silence MS");
            ExpectSilence(std::atoi(words[1].c_str()));
        } else if (verb == "listen") {
            Need(words, 2, "listen MS");
            Listen(std::atoi(words[1].c_str()));
        } else if (verb == "raw") {
            Need(words, 2, "raw HEX");
            SendRaw(words[1]);
        } else {
            throw std::runtime_error("unknown command \"" + verb + "\"");
        }
    }

    static int TimeoutOf(const Words &words, std::size_t place)
    {
        return words.size() > place ? std::atoi(words[place].c_str()) : kTimeoutMs;
    }

    static std::string After(const std::string &line, int words)
    {
        std::istringstream input(line);
        std::string word;
        std::string rest;
        for (int i = 0; i < words; i++) {
            input >> word;
        }
        std::getline(input >> std::ws, rest);
        return rest;
    }

    std::string NextId()
    {
        char id[16];
        std::snprintf(id, sizeof id, "%04d", next_id_++);
        return id;
    }

    // A message received before is no answer to the one that is sent now.
    void Begin()
    {
        while (Readable(0) && Receive()) {
        }
        cursor_ = history_.size();
    }

    void Send(igtl::MessageBase *message)
    {
        if (!channel_->Send(message->GetPackPointer(), message->GetPackSize())) {
            throw std::runtime_error("the connection is closed");
        }
    }

    void SendString(const std::string &name, const std::string &text)
    {
        igtl::StringMessage::Pointer message = igtl::StringMessage::New();
        message->SetDeviceName(name.c_str());
        message->SetString(text.c_str());
        message->Pack();
        Send(message);
    }

    void SendTransform(const std::string &name, const Words &words, std::size_t first)
    {
        igtl::TransformMessage::Pointer message = igtl::TransformMessage::New();
        igtl::Matrix4x4 matrix = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
        const std::size_t count = words.size() - first;
        if (count != 12 && count != 16) {
            throw std::runtime_error("a matrix has 12 or 16 numbers, row by row");
        }
        for (std::size_t i = 0; i < 12; i++) {
            matrix[i / 4][i % 4] = std::strtof(words[first + i].c_str(), NULL);
        }
        message->SetDeviceName(name.c_str());
        message->SetMatrix(matrix);
        message->Pack();
        Send(message);
    }

    // Each is a word for what it has, then its entry and its target in mm.
    void SendTrajectories(const Words &words)
    {
        igtl::TrajectoryMessage::Pointer message = igtl::TrajectoryMessage::New();
        for (std::size_t first = 2; first + 7 <= words.size(); first += 7) {
            igtlFloat32 places[6];
            for (std::size_t i = 0; i < 6; i++) {
                places[i] = std::strtof(words[first + 1 + i].c_str(), NULL);
            }
            igtl::TrajectoryElement::Pointer element = igtl::TrajectoryElement::New();
            element->SetName(words[1].c_str());
            element->SetGroupName("Trajectory");
            element->SetType(TrajectoryType(words[first]));
            element->SetEntryPosition(places);
            element->SetTargetPosition(&places[3]);
            message->AddTrajectoryElement(element);
        }
        message->SetDeviceName(words[1].c_str());
        message->Pack();
        Begin();
        Send(message);
    }

    static igtlUint8 TrajectoryType(const std::string &word)
    {
        if (word == "both") {
            return igtl::TrajectoryElement::TYPE_ENTRY_TARGET;
        }
        return word == "entry" ? igtl::TrajectoryElement::TYPE_ENTRY_ONLY
                               : igtl::TrajectoryElement::TYPE_TARGET_ONLY;
    }

    template <class Real> void SendArray(const Words &words, int type)
    {
        const std::size_t columns = static_cast<std::size_t>(std::atoi(words[3].c_str()));
        std::vector<Real> numbers;
        for (std::size_t i = 4; i < words.size(); i++) {
            numbers.push_back(static_cast<Real>(std::strtod(words[i].c_str(), NULL)));
        }
        if (columns == 0 || numbers.size() % columns != 0) {
            throw std::runtime_error("rows of an array are as long as each other");
        }
        igtl::ArrayBase::IndexType size(2);
        size[0] = static_cast<igtlUint16>(numbers.size() / columns);
        size[1] = static_cast<igtlUint16>(columns);
        igtl::Array<Real> array;
        array.SetSize(size);
        array.SetArray(&numbers[0]);
        igtl::NDArrayMessage::Pointer message = igtl::NDArrayMessage::New();
        message->SetDeviceName(words[1].c_str());
        message->SetArray(type, &array);
        message->Pack();
        Begin();
        Send(message);
    }

    void SendPhase(const std::string &phase, const std::string &id)
    {
        Begin();
        const double sent_ms = Now();
        SendString("CMD_" + id, phase);
        ReportAcknowledgement(Await("STRING", "ACK_" + id, kTimeoutMs), sent_ms);
    }

    void SendPose(const std::string &prefix, const Words &words)
    {
        const std::string id = NextId();
        Begin();
        const double sent_ms = Now();
        SendTransform(prefix + id, words, 1);
        const Received echo = Await("TRANSFORM", "ACK_" + id, kTimeoutMs);
        ReportAcknowledgement(echo, sent_ms);
        for (std::size_t i = 0; i < 12; i++) {
            const float sent = std::strtof(words[1 + i].c_str(), NULL);
            const bool are_nan = std::isnan(sent) && std::isnan(echo.numbers[i]);
            if (!are_nan && std::memcmp(&sent, &echo.numbers[i], sizeof sent) != 0) {
                throw std::runtime_error(
                    "the acknowledgement does not repeat the matrix that was sent");
            }
        }
    }

    void ReportAcknowledgement(const Received &received, double sent_ms)
    {
        std::cout << "{\"t_ms\":" << Number(Now())
                  << ",\"type\":\"ACK\",\"name\":" << Quote(received.name)
                  << ",\"ack_ms\":" << Number(received.t_ms - sent_ms) << "}" << std::endl;
    }

    void SendRaw(const std::string &hex)
    {
        std::string bytes;
        for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
            bytes += static_cast<char>(std::strtol(hex.substr(i, 2).c_str(), NULL, 16));
        }
        Begin();
        if (!channel_->Send(bytes.data(), static_cast<int>(bytes.size()))) {
            throw std::runtime_error("the connection is closed");
        }
    }

    // Something can be read: a message, or the end.
    bool Readable(int timeout_ms)
    {
        pollfd waiting = {channel_->Descriptor(), POLLIN, 0};
        return poll(&waiting, 1, timeout_ms) > 0;
    }

    Received Await(const std::string &type, const std::string &name, int timeout_ms)
    {
        const double until_ms = Now() + timeout_ms;
        while (true) {
            while (cursor_ < history_.size()) {
                const Received &received = history_[cursor_++];
                if (received.type == type && (name == "*" || received.name == name)) {
                    return received;
                }
            }
            const int left_ms = static_cast<int>(until_ms - Now());
            if (left_ms <= 0 || !Readable(left_ms)) {
                std::ostringstream message;
                message << "no " << type << " " << name << " within " << timeout_ms << " ms";
                throw std::runtime_error(message.str());
            }
            if (!Receive()) {
                throw std::runtime_error("the connection was closed while waiting for " + type +
                                         " " + name);
            }
        }
    }

    void Expect(const Words &words)
    {
        const Received received = Await(words[1], words[2], TimeoutOf(words, 4));
        if (received.code != std::atoi(words[3].c_str())) {
            std::ostringstream message;
            message << words[1] << " " << words[2] << " has code " << received.code << " ("
                    << received.text << "), expected " << words[3];
            throw std::runtime_error(message.str());
        }
    }

    void Ask(const std::string &name)
    {
        Begin();
        if (name == "CURRENT_STATUS") {
            igtl::GetStatusMessage::Pointer message = igtl::GetStatusMessage::New();
            message->SetDeviceName(name.c_str());
            message->Pack();
            Send(message);
            Await("STATUS", name, kTimeoutMs);
        } else {
            igtl::GetTransformMessage::Pointer message = igtl::GetTransformMessage::New();
            message->SetDeviceName(name.c_str());
            message->Pack();
            Send(message);
            Await("TRANSFORM", name, kTimeoutMs);
        }
    }

    void AskFor(const std::string &type, const std::string &name)
    {
        Question::Pointer question = Question::New(type);
        question->SetDeviceName(name.c_str());
        question->Pack();
        Begin();
        Send(question);
    }

    void Track(const std::string &name, int resolution_ms)
    {
        igtl::StartTrackingDataMessage::Pointer message = igtl::StartTrackingDataMessage::New();
        message->SetDeviceName(name.c_str());
        message->SetResolution(resolution_ms);
        message->SetCoordinateName("Patient");
        message->Pack();
        Begin();
        Send(message);
    }

    void ExpectSilence(int time_ms)
    {
        const std::size_t before = history_.size();
        Listen(time_ms);
        if (history_.size() != before) {
            throw std::runtime_error("silence was expected, but a message came");
        }
    }

    void Listen(int time_ms)
    {
        const double until_ms = Now() + time_ms;
        while (Now() < until_ms) {
            if (Readable(static_cast<int>(std::ceil(until_ms - Now()))) && !Receive()) {
                throw std::runtime_error("the connection was closed");
            }
        }
    }

    // Reads one message and prints it. False when the connection has ended.
    bool Receive()
    {
        igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
        header->InitPack();
        const int count = channel_->Receive(header->GetPackPointer(), header->GetPackSize());
        if (count != header->GetPackSize()) {
            return false;
        }
        header->Unpack();
        Received received = {
            header->GetDeviceType(), header->GetDeviceName(), 0, "", std::vector<float>(), Now()};
        const std::string content = ReadBody(header, &received);
        std::cout << "{\"t_ms\":" << Number(received.t_ms) << ",\"type\":" << Quote(received.type)
                  << ",\"name\":" << Quote(received.name) << content << "}" << std::endl;
        history_.push_back(received);
        return true;
    }

    template <class Message> typename Message::Pointer Body(igtl::MessageHeader *header)
    {
        typename Message::Pointer message = Message::New();
        message->SetMessageHeader(header);
        message->AllocatePack();
        channel_->Receive(message->GetPackBodyPointer(), message->GetPackBodySize());
        if ((message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) == 0) {
            throw std::runtime_error(std::string("the checksum of ") + header->GetDeviceType() +
                                     " " + header->GetDeviceName() + " is wrong");
        }
        return message;
    }

    std::string ReadBody(igtl::MessageHeader *header, Received *received)
    {
        std::ostringstream content;
        if (received->type == "STATUS") {
            igtl::StatusMessage::Pointer message = Body<igtl::StatusMessage>(header);
            received->code = message->GetCode();
            received->text = message->GetStatusString();
            content << ",\"code\":" << received->code
                    << ",\"error_name\":" << Quote(message->GetErrorName())
                    << ",\"text\":" << Quote(received->text);
        } else if (received->type == "STRING") {
            content << ",\"text\":" << Quote(Body<igtl::StringMessage>(header)->GetString());
        } else if (received->type == "TRANSFORM") {
            igtl::Matrix4x4 matrix;
            Body<igtl::TransformMessage>(header)->GetMatrix(matrix);
            content << Matrix(matrix, received);
        } else if (header->GetBodySizeToRead() == 0) {
            content << ",\"is_empty\":true";
        } else if (received->type == "TDATA") {
            igtl::Matrix4x4 matrix;
            igtl::TrackingDataElement::Pointer element;
            Body<igtl::TrackingDataMessage>(header)->GetTrackingDataElement(0, element);
            element->GetMatrix(matrix);
            content << ",\"element\":" << Quote(element->GetName()) << Matrix(matrix, received);
        } else if (received->type == "RTS_TDATA") {
            received->code = Body<igtl::RTSTrackingDataMessage>(header)->GetStatus();
            content << ",\"code\":" << received->code;
        } else if (received->type == "CAPABILITY") {
            content << ",\"types\":[" << Types(Body<igtl::CapabilityMessage>(header)->GetTypes())
                    << "]";
        } else if (received->type == "SENSOR") {
            igtl::SensorMessage::Pointer message = Body<igtl::SensorMessage>(header);
            content << ",\"unit\":" << Unit(message) << ",\"values\":" << Values(message);
        } else if (received->type == "POINT") {
            igtl::PointElement::Pointer point;
            igtlFloat32 position[3];
            Body<igtl::PointMessage>(header)->GetPointElement(0, point);
            point->GetPosition(position);
            received->numbers.assign(position, position + 3);
            content << ",\"position\":" << List(received->numbers);
        } else {
            channel_->Skip(header->GetBodySizeToRead());
        }
        return content.str();
    }

    static std::string Matrix(const igtl::Matrix4x4 &matrix, Received *received)
    {
        for (int i = 0; i < 12; i++) {
            received->numbers.push_back(matrix[i / 4][i % 4]);
        }
        return ",\"matrix\":" + List(received->numbers);
    }

    static std::string Values(igtl::SensorMessage *message)
    {
        std::string list;
        for (unsigned i = 0; i < message->GetLength(); i++) {
            list += (i == 0 ? "" : ",") + Number(message->GetValue(i));
        }
        return "[" + list + "]";
    }

    // Newton is the only unit of a SENSOR that has a name here.
    static std::string Unit(igtl::SensorMessage *message)
    {
        igtl::Unit::Pointer newton = igtl::Unit::New();
        newton->Init();
        newton->Append(igtl::Unit::SI_DERIVED_NEWTON, 1);
        return message->GetUnit() == newton->Pack() ? "\"N\"" : "null";
    }

    static std::string Types(const std::vector<std::string> &types)
    {
        std::string list;
        for (std::size_t i = 0; i < types.size(); i++) {
            list += (i == 0 ? "" : ",") + Quote(types[i].c_str());
        }
        return list;
    }

    static std::string List(const std::vector<float> &numbers)
    {
        std::string list = "[";
        for (std::size_t i = 0; i < numbers.size(); i++) {
            list += (i == 0 ? "" : ",") + Number(numbers[i]);
        }
        return list + "]";
    }

    Clock::time_point start_;
    Channel::Pointer channel_;
    std::vector<Received> history_;
    std::size_t cursor_;
    int next_id_;
};

enum { kHost = 0, kPort, kOptions };

const command_option_t kKnown[kOptions] = {
    {"host", "ADDRESS", "of the server; default 127.0.0.1", 0, 0, false},
    {"port", "PORT", "of workphases 18936, the default; of transforms 18944", 1, 65535, false}};

const char kCommands[] =
    "Without commands they are read from the standard input, one a line. All that\n"
    "arrives is printed as lines of JSON. NAME is that of a message. Commands:\n"
    "  \"phase NAME\"                    command a workphase\n"
    "  \"registration NUMBERS\"          send a registration; 12 or 16 numbers, by rows\n"
    "  \"target NUMBERS\"                send a target, the same\n"
    "  \"transform NAME NUMBERS\"        send any transform\n"
    "  \"string NAME TEXT\"              send any string\n"
    "  \"traj NAME both NUMBERS\"        plan a way: entry and target in mm\n"
    "  \"array NAME 64 COLUMNS NUMBERS\" send an array, by rows\n"
    "  \"get NAME\"                      ask for a transform, or for CURRENT_STATUS\n"
    "  \"ask TYPE NAME\"                 send a message without content\n"
    "  \"track NAME MS\"                 ask for tracking data every MS milliseconds\n"
    "  \"wait TYPE NAME MS\"             wait for a message, at most MS milliseconds\n"
    "  \"expect STATUS NAME CODE MS\"    wait for a status with that code\n"
    "  \"expect-silence MS\"             nothing may arrive\n"
    "  \"listen MS\"                     print what arrives\n"
    "  \"raw HEX\"                       send bytes\n"
    "\n"
    "Exit code 0: all commands done. 1: one failed, said in a sentence. 2: wrong\n"
    "command line.\n";

const command_line_t kCommandLine = {
    "boresight-client",
    "Talks to Boresight by OpenIGTLink, as a navigation program does.",
    "[OPTION...] [COMMAND...]",
    kKnown,
    kOptions,
    0,
    COMMAND_LINE_MANY,
    kCommands};

} // namespace

int main(int count, char **arguments)
{
    std::ios::sync_with_stdio(false);
    const char *values[kOptions];
    int first;
    const int code = command_line_read(&kCommandLine, count, arguments, values, &first);
    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    const std::string host = values[kHost] != NULL ? values[kHost] : "127.0.0.1";
    const int port = values[kPort] != NULL ? std::atoi(values[kPort]) : 18936;
    const Words commands(arguments + first, arguments + count);
    try {
        Client client;
        client.Connect(host, port);
        for (std::size_t i = 0; i < commands.size(); i++) {
            client.Run(commands[i]);
        }
        std::string line;
        while (commands.empty()) {
            client.WaitForInput();
            if (!std::getline(std::cin, line)) {
                break;
            }
            client.Run(line);
        }
    } catch (const std::exception &problem) {
        std::cerr << "boresight-client: " << problem.what() << std::endl;
        return 1;
    }
    return 0;
}
