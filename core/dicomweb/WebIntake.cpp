// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebIntake.h"

#include <utility>

namespace core {

namespace {

/// A server that sends what nobody asked for is heard that often.
constexpr int mostUnasked = 100;

} // namespace

WebIntake::WebIntake(const DownloadFolder& folder, const QSet<QString>& awaited, bool takesAll,
    QString nodeName, const Progress& progress)
    : m_folder(folder)
    , m_takesAll(takesAll)
    , m_missing(awaited)
    , m_total(takesAll ? 0 : awaited.size())
    , m_nodeName(std::move(nodeName))
    , m_progress(progress)
    , m_part(folder.partPathOf(QStringLiteral("1")))
{
}

WebIntake::~WebIntake()
{
    dropPart();
}

Result<void> WebIntake::begin(const WebAnswer& answer)
{
    dropPart();
    m_reader.reset();
    if (answer.status == 204)
        return {};
    if (const auto boundary = MultipartReader::boundaryOf(answer.contentType)) {
        PartSink& sink = *this;
        m_reader.emplace(*boundary, m_nodeName, sink);
        return {};
    }
    // Of one object some servers make no multipart.
    if (answer.contentType.startsWith("application/dicom")
        && !answer.contentType.startsWith("application/dicom+"))
        return beginPart();
    return failure(ErrorCode::NodeNonsense, m_nodeName,
        Clause::saying("it answers with '%1' where DICOM objects were asked for",
            QString::fromLatin1(answer.contentType.left(60))));
}

Result<void> WebIntake::take(const QByteArray& bytes)
{
    return m_reader ? m_reader->feed(bytes) : takePart(bytes.constData(), bytes.size());
}

Result<void> WebIntake::end()
{
    if (!m_reader)
        return m_part.isOpen() ? endPart() : Result<void>();
    if (!m_reader->isComplete())
        return failure(ErrorCode::NodeLost, m_nodeName, Clause::saying("its answer is cut short"));
    return {};
}

Result<void> WebIntake::beginPart()
{
    dropPart();
    if (!m_part.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return failure(ErrorCode::FileUnwritable, m_folder.target(), m_part.errorString());
    return {};
}

Result<void> WebIntake::takePart(const char* bytes, qsizetype size)
{
    // A disk that fills up takes a part first.
    while (size > 0) {
        const qint64 count = m_part.write(bytes, size);
        if (count <= 0)
            return failure(ErrorCode::FileUnwritable, m_folder.target(), m_part.errorString());
        bytes += count;
        size -= count;
    }
    return {};
}

Result<void> WebIntake::endPart()
{
    m_part.close();
    const Result<QString> uid = soundObject(m_part.fileName());
    if (!uid || !(m_takesAll || m_missing.contains(*uid))) {
        if (!uid && !m_refusal)
            m_refusal = uid.error();
        dropPart();
        if (++m_unasked > mostUnasked) {
            return failure(ErrorCode::NodeNonsense, m_nodeName,
                Clause::saying("it sends what nobody asked for"));
        }
        return {};
    }
    if (Result<void> accepted = m_folder.accept(m_part.fileName(), *uid); !accepted)
        return accepted;
    m_missing.remove(*uid);
    m_received.insert(*uid);
    ++m_accepted;
    m_progress.report(ProgressStep::Downloading, received(), int(m_total));
    return {};
}

void WebIntake::dropPart()
{
    m_part.close();
    m_part.remove();
}

} // namespace core
