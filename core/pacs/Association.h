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

/// A kind of object or service that is proposed to a node, in one of some transfer syntaxes.
struct ProposedContext {
    QByteArray abstractSyntax;
    std::vector<QByteArray> transferSyntaxes;
    bool nodeSends = false; ///< C-GET: the node stores at us
};

/// The two that every DICOM application understands.
[[nodiscard]] std::vector<QByteArray> plainSyntaxes();

/// "CTImageStorage" for the UID of that; a UID without a name as it is.
[[nodiscard]] QString nameOfUid(const QByteArray& uid);

/// An association with a node, and what is said on it. Data sets that arrive are handed on as
/// bytes, never parsed here: they pass core/dicom's preflight first. Only for sources of core/pacs.
class Association {
public:
    /// Asks the node for one. NodeUnreachable, NodeRejects, NodeTimeout, NodeLost, NodeNonsense,
    /// Cancelled.
    /// @param whole how long it may take, with all that is said on it; zero: as long as things come
    [[nodiscard]] static Result<Association> request(const PacsNode& node,
        const std::vector<ProposedContext>& contexts, const Progress& progress,
        Patience::Seconds whole = {});
    struct Parts;
    explicit Association(std::unique_ptr<Parts> parts);

    Association(Association&&) noexcept;
    Association& operator=(Association&&) noexcept;
    /// Aborts it where release() did not end it.
    ~Association();

    [[nodiscard]] T_ASC_Association* get() const;
    [[nodiscard]] const PacsNode& node() const;
    /// The number of a context that the node accepted for this kind, in @p transferSyntax if one is
    /// named. NodeRefuses.
    [[nodiscard]] Result<std::uint8_t> context(
        const QByteArray& abstractSyntax, const QByteArray& transferSyntax = {}) const;
    /// The transfer syntax of an accepted context.
    [[nodiscard]] QByteArray transferSyntax(std::uint8_t context) const;
    [[nodiscard]] std::uint16_t nextMessageId();

    [[nodiscard]] Result<void> send(
        std::uint8_t context, T_DIMSE_Message& message, DcmDataset* data = nullptr);
    [[nodiscard]] Result<T_DIMSE_Message> receive(std::uint8_t& context);
    /// Takes a data set's bytes as they arrive.
    using Sink = std::function<void(const char* bytes, std::size_t size)>;
    [[nodiscard]] Result<void> receiveData(std::uint8_t context, const Sink& sink);

    /// Something whole went over: the node is awaited anew (Patience).
    void notePassed();
    /// Ends it in good order.
    void release();
    /// The other side ended it so.
    void markReleased();
    /// What a condition of DCMTK means here.
    [[nodiscard]] Error error(const OFCondition& condition) const;

private:
    std::unique_ptr<Parts> m_parts;
};

} // namespace core
