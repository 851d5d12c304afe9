// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace core {

/// Receives the parts of a multipart body as they arrive. An error ends the reading.
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

/// Reads a body of type multipart (RFC 2046 5.1) piece by piece; memory does not depend on its
/// length. A part ends as its Content-Length says, else at the boundary.
class MultipartReader {
public:
    /// @param nodeName for messages
    MultipartReader(const QByteArray& boundary, QString nodeName, PartSink& sink);

    /// Errors: NodeNonsense, and those of the sink.
    [[nodiscard]] Result<void> feed(const QByteArray& bytes);
    /// Whether the closing boundary was received, so that nothing is missing.
    [[nodiscard]] bool isComplete() const { return m_state == State::Epilogue; }

    /// The boundary in a Content-Type; none if it is not multipart or the boundary is invalid.
    [[nodiscard]] static std::optional<QByteArray> boundaryOf(const QByteArray& contentType);

private:
    enum class State {
        Preamble, ///< before the first boundary
        AfterBoundary, ///< two dashes end everything, a line end begins a part
        Headers,
        Counted, ///< a part of known length
        CountedEnd, ///< the boundary must follow
        Searched, ///< a part that ends at the boundary
        Epilogue,
    };
    /// @return whether it made progress, so that the rest can be examined
    [[nodiscard]] Result<bool> step();
    [[nodiscard]] Result<bool> readHeaders();
    [[nodiscard]] Result<bool> readSearched();
    [[nodiscard]] tl::unexpected<Error> nonsense(const Clause& what) const;

    QByteArray m_dashes; ///< "--boundary"
    QByteArray m_delimiter; ///< the same with the line end before it
    QString m_nodeName;
    PartSink& m_sink;
    State m_state = State::Preamble;
    QByteArray m_waiting; ///< not processed yet; bounded
    qint64 m_left = 0; ///< remaining bytes of a counted part
};

} // namespace core
