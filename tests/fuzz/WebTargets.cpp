// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/dicom/base/DicomText.h"
#include "core/dicomweb/JsonAnswer.h"
#include "core/dicomweb/MultipartReader.h"
#include "core/dicomweb/WebQuery.h"

#include <QByteArrayList>

#include <algorithm>

namespace test {

using namespace core;

namespace {

QByteArray toBytes(FuzzBytes bytes)
{
    return QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
}

class KeptParts : public PartSink {
public:
    Result<void> beginPart() override
    {
        parts.append(QByteArray());
        return {};
    }
    Result<void> takePart(const char* bytes, qsizetype size) override
    {
        if (parts.isEmpty() || size < 1)
            qFatal("bytes of no part");
        parts.back().append(bytes, size);
        return {};
    }
    Result<void> endPart() override
    {
        if (++ended != parts.size())
            qFatal("a part ends that did not begin");
        return {};
    }

    QByteArrayList parts;
    qsizetype ended = 0;
};

/// What a body is if it comes in pieces of so many bytes.
struct Heard {
    QByteArrayList parts;
    bool sound = true;
    bool complete = false;
    bool operator==(const Heard&) const = default;
};

Heard heardInPieces(const QByteArray& body, qsizetype piece)
{
    KeptParts sink;
    MultipartReader reader("a-b", QStringLiteral("node"), sink);
    Heard heard;
    for (qsizetype at = 0; heard.sound && at < body.size(); at += piece)
        heard.sound = reader.feed(body.mid(at, piece)).has_value();
    heard.parts = sink.parts;
    heard.complete = reader.isComplete();
    return heard;
}

} // namespace

void fuzzMultipart(FuzzBytes bytes)
{
    (void)MultipartReader::boundaryOf(toBytes(bytes));
    // Within the limits of heads, which a body can exceed only by how it comes.
    constexpr std::size_t longest = 60'000;
    if (bytes.size() < 2 || bytes.size() > longest)
        return;
    const QByteArray body = toBytes(bytes.subspan(1));
    constexpr int mostBytes = 16;
    if (heardInPieces(body, body.size()) != heardInPieces(body, 1 + bytes[0] % mostBytes))
        qFatal("the parts of a body depend on the pieces it comes in");
}

void fuzzWebAnswer(FuzzBytes bytes)
{
    const Result<QJsonArray> answers = jsonAnswers(toBytes(bytes), QStringLiteral("node"));
    if (!answers)
        return;
    for (const QJsonValue& value : *answers) {
        const JsonAnswer one(value.toObject());
        for (const char* tag : {"0020000D", "0020000E", "00080018", "00100010", "00080061"}) {
            for (const QString& text : one.texts(tag)) {
                (void)isDicomUid(text);
                (void)dicomDate(text);
            }
        }
        if (one.count("00201208") < -1)
            qFatal("fewer than none");
    }
}

} // namespace test
