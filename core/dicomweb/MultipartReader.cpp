// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/MultipartReader.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// Of what stands before a part, and of its headers.
constexpr qsizetype longestHead = 64 << 10;
constexpr qsizetype longestBoundary = 200; // RFC 2046 has 70

} // namespace

MultipartReader::MultipartReader(const QByteArray& boundary, QString nodeName, PartSink& sink)
    : m_dashes("--" + boundary)
    , m_delimiter("\r\n--" + boundary)
    , m_nodeName(std::move(nodeName))
    , m_sink(sink)
{
}

std::optional<QByteArray> MultipartReader::boundaryOf(const QByteArray& contentType)
{
    if (!contentType.trimmed().toLower().startsWith("multipart/"))
        return std::nullopt;
    const qsizetype at = contentType.toLower().indexOf("boundary=");
    if (at < 0)
        return std::nullopt;
    QByteArray rest = contentType.mid(at + 9).trimmed();
    QByteArray boundary;
    if (rest.startsWith('"')) {
        boundary = rest.mid(1, rest.indexOf('"', 1) - 1);
    } else {
        const qsizetype end = rest.indexOf(';');
        boundary = (end < 0 ? rest : rest.left(end)).trimmed();
    }
    if (boundary.isEmpty() || boundary.size() > longestBoundary)
        return std::nullopt;
    return boundary;
}

tl::unexpected<Error> MultipartReader::nonsense(const Clause& what) const
{
    return failure(ErrorCode::NodeNonsense, m_nodeName, what);
}

Result<void> MultipartReader::feed(const QByteArray& bytes)
{
    m_waiting += bytes;
    for (;;) {
        const Result<bool> went = step();
        if (!went)
            return tl::unexpected<Error>(went.error());
        if (!*went)
            return {};
    }
}

Result<bool> MultipartReader::step()
{
    switch (m_state) {
    case State::Preamble: {
        const qsizetype at = m_waiting.indexOf(m_dashes);
        if (at < 0) {
            if (m_waiting.size() > longestHead)
                return nonsense(Clause::saying("it sends no parts where it promised some"));
            return false;
        }
        m_waiting.remove(0, at + m_dashes.size());
        m_state = State::AfterBoundary;
        return true;
    }
    case State::AfterBoundary: {
        if (m_waiting.startsWith("--")) {
            m_waiting.clear();
            m_state = State::Epilogue;
            return true;
        }
        const qsizetype end = m_waiting.indexOf("\r\n");
        if (end < 0) {
            if (m_waiting.size() > longestHead)
                return nonsense(Clause::saying("a boundary of parts has no end"));
            return false;
        }
        if (!m_waiting.left(end).trimmed().isEmpty())
            return nonsense(Clause::saying("a boundary of parts is not what it announced"));
        // The line end stays: without headers the empty line follows at once.
        m_waiting.remove(0, end);
        m_state = State::Headers;
        return true;
    }
    case State::Headers:
        return readHeaders();
    case State::Counted: {
        const qsizetype size = qsizetype(std::min<qint64>(m_left, m_waiting.size()));
        if (size > 0) {
            if (const auto taken = m_sink.takePart(m_waiting.constData(), size); !taken)
                return tl::unexpected<Error>(taken.error());
            m_waiting.remove(0, size);
            m_left -= size;
        }
        if (m_left > 0)
            return false;
        m_state = State::CountedEnd;
        return true;
    }
    case State::CountedEnd: {
        if (m_waiting.size() < m_delimiter.size())
            return false;
        if (!m_waiting.startsWith(m_delimiter))
            return nonsense(Clause::saying("a part is not as long as it said"));
        m_waiting.remove(0, m_delimiter.size());
        m_state = State::AfterBoundary;
        if (const auto ended = m_sink.endPart(); !ended)
            return tl::unexpected<Error>(ended.error());
        return true;
    }
    case State::Searched:
        return readSearched();
    case State::Epilogue:
        m_waiting.clear();
        return false;
    }
    return false;
}

Result<bool> MultipartReader::readHeaders()
{
    const qsizetype end = m_waiting.indexOf("\r\n\r\n");
    if (end < 0) {
        if (m_waiting.size() > longestHead)
            return nonsense(Clause::saying("the headers of a part have no end"));
        return false;
    }
    if (end > longestHead)
        return nonsense(Clause::saying("the headers of a part have no end"));
    m_state = State::Searched;
    for (const QByteArray& line : m_waiting.left(end).split('\n')) {
        const qsizetype colon = line.indexOf(':');
        if (colon < 0 || line.left(colon).trimmed().toLower() != "content-length")
            continue;
        bool isNumber = false;
        m_left = line.mid(colon + 1).trimmed().toLongLong(&isNumber);
        if (!isNumber || m_left < 0)
            return nonsense(Clause::saying("a part has a length that is no number"));
        m_state = State::Counted;
    }
    m_waiting.remove(0, end + 4);
    if (const auto begun = m_sink.beginPart(); !begun)
        return tl::unexpected<Error>(begun.error());
    return true;
}

Result<bool> MultipartReader::readSearched()
{
    const qsizetype at = m_waiting.indexOf(m_delimiter);
    // What may be the beginning of a boundary waits for the rest of it.
    const qsizetype sure =
        at < 0 ? std::max<qsizetype>(0, m_waiting.size() - m_delimiter.size() + 1) : at;
    if (sure > 0) {
        if (const auto taken = m_sink.takePart(m_waiting.constData(), sure); !taken)
            return tl::unexpected<Error>(taken.error());
        m_waiting.remove(0, sure);
    }
    if (at < 0)
        return false;
    m_waiting.remove(0, m_delimiter.size());
    m_state = State::AfterBoundary;
    if (const auto ended = m_sink.endPart(); !ended)
        return tl::unexpected<Error>(ended.error());
    return true;
}

} // namespace core
