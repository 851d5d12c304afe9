// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/pacs/PacsNode.h"
#include "core/pacs/Patience.h"

#include <QByteArray>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class DcmDataset;
class OFCondition;
struct T_ASC_Association;
struct T_DIMSE_Message;

namespace core {

/// A SOP class that is proposed to a node, with possible transfer syntaxes.
struct ProposedContext {
    QByteArray abstractSyntax;
    std::vector<QByteArray> transferSyntaxes;
    bool nodeSends = false; ///< C-GET: the node stores objects at this program
};

/// The two transfer syntaxes that every DICOM application supports.
[[nodiscard]] std::vector<QByteArray> plainSyntaxes();

/// "CTImageStorage" for its UID; a UID without a name is returned unchanged.
[[nodiscard]] QString nameOfUid(const QByteArray& uid);

/// A DICOM association with a node. Received data sets are passed on as bytes and never parsed
/// here: they go through core/dicom's preflight first. Only for sources of core/pacs.
class Association {
public:
    /// Requests an association. Errors: NodeUnreachable, NodeRejects, NodeTimeout, NodeLost,
    /// NodeNonsense, Cancelled.
    /// @param whole limit for everything done with it; zero: no limit while data arrive
    [[nodiscard]] static Result<Association> request(const PacsNode& node,
        const std::vector<ProposedContext>& contexts, const Progress& progress,
        Patience::Seconds whole = {});
    struct Parts;
    explicit Association(std::unique_ptr<Parts> parts);

    Association(Association&&) noexcept;
    Association& operator=(Association&&) noexcept;
    /// Aborts it unless release() has ended it.
    ~Association();

    [[nodiscard]] T_ASC_Association* get() const;
    [[nodiscard]] const PacsNode& node() const;
    /// The number of an accepted context for this class, with @p transferSyntax if one is given.
    /// Errors: NodeRefuses.
    [[nodiscard]] Result<std::uint8_t> context(
        const QByteArray& abstractSyntax, const QByteArray& transferSyntax = {}) const;
    /// The transfer syntax of an accepted context.
    [[nodiscard]] QByteArray transferSyntax(std::uint8_t context) const;
    [[nodiscard]] std::uint16_t nextMessageId();

    [[nodiscard]] Result<void> send(
        std::uint8_t context, T_DIMSE_Message& message, DcmDataset* data = nullptr);
    [[nodiscard]] Result<T_DIMSE_Message> receive(std::uint8_t& context);
    /// Receives the bytes of a data set as they arrive.
    using Sink = std::function<void(const char* bytes, std::size_t size)>;
    [[nodiscard]] Result<void> receiveData(std::uint8_t context, const Sink& sink);

    /// Records that something complete was transferred, so that waiting begins anew (Patience).
    void notePassed();
    /// Ends the association properly.
    void release();
    /// Records that the other side ended it properly.
    void markReleased();
    /// Converts a DCMTK condition to an error.
    [[nodiscard]] Error error(const OFCondition& condition) const;

private:
    std::unique_ptr<Parts> m_parts;
};

} // namespace core
