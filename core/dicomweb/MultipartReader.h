// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace core {

/// Takes the parts of a multipart body as they arrive. Errors end the reading.
class PartSink {
public:
    PartSink() = default;
    PartSink(const PartSink&) = delete;
    PartSink& operator=(const PartSink&) = delete;
    virtual ~PartSink() = default;
    [[nodiscard]] virtual Result<void> beginPart() = 0;
    [[nodiscard]] virtual Result<void> takePart(const char* bytes, qsizetype size) = 0;
    [[nodiscard]] virtual Result<void> endPart() = 0;
};

/// Reads a body of type multipart (RFC 2046 5.1) piece by piece, in memory that does not depend on
/// its length. A part ends where its Content-Length says, else at the boundary.
class MultipartReader {
public:
    /// @param nodeName for messages
    MultipartReader(const QByteArray& boundary, QString nodeName, PartSink& sink);

    /// NodeNonsense, and errors of the sink.
    [[nodiscard]] Result<void> feed(const QByteArray& bytes);
    /// Whether the closing boundary came: nothing is missing.
    [[nodiscard]] bool isComplete() const { return m_state == State::Epilogue; }

    /// The boundary that a Content-Type names; none if it is not multipart, or none sensible.
    [[nodiscard]] static std::optional<QByteArray> boundaryOf(const QByteArray& contentType);

private:
    enum class State {
        Preamble, ///< before the first boundary
        AfterBoundary, ///< two dashes end it all, a line end begins a part
        Headers,
        Counted, ///< a part of known length
        CountedEnd, ///< behind which the boundary must stand
        Searched, ///< a part that lasts until the boundary
        Epilogue,
    };
    /// @return whether it went on, so that the rest may be looked at
    [[nodiscard]] Result<bool> step();
    [[nodiscard]] Result<bool> readHeaders();
    [[nodiscard]] Result<bool> readSearched();
    [[nodiscard]] tl::unexpected<Error> nonsense(const char* what) const;

    QByteArray m_dashes; ///< "--boundary"
    QByteArray m_delimiter; ///< the same with the line end before it
    QString m_nodeName;
    PartSink& m_sink;
    State m_state = State::Preamble;
    QByteArray m_waiting; ///< not taken yet; bounded
    qint64 m_left = 0; ///< of a counted part
};

} // namespace core
