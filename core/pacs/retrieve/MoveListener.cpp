// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/MoveListener.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/pacs/AssociationParts.h"
#include "core/pacs/retrieve/StorageContexts.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dcmlayer.h>
#include <dcmtk/dcmnet/dimse.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace core {

namespace {

/// The syntax in which objects of a context shall come: the first that Burin reads, or else the
/// first that is proposed, since what it does not read belongs to the study as well.
QByteArray chosenSyntax(const T_ASC_PresentationContext& context)
{
    std::vector<QByteArray> proposed;
    for (int i = 0; i < int(context.transferSyntaxCount); ++i)
        proposed.emplace_back(context.proposedTransferSyntaxes[i]);
    const std::vector<QByteArray>& readable = readableSyntaxes();
    const auto found =
        std::find_first_of(readable.begin(), readable.end(), proposed.begin(), proposed.end());
    if (found != readable.end())
        return *found;
    return proposed.empty() ? QByteArray() : proposed.front();
}

/// Nodes give the whole move up if one kind of object is refused. What nobody asked for the intake
/// refuses, object by object.
OFCondition acceptContexts(T_ASC_Parameters* parameters)
{
    const int count = ASC_countPresentationContexts(parameters);
    for (int i = 0; i < count; ++i) {
        T_ASC_PresentationContext context{};
        OFCondition done = ASC_getPresentationContext(parameters, i, &context);
        if (done.bad())
            return done;
        const QByteArray uid(context.abstractSyntax);
        const QByteArray syntax = chosenSyntax(context);
        const bool isKnown = uid == UID_VerificationSOPClass || mayBeStorage(uid);
        if (isKnown && !syntax.isEmpty()) {
            done = ASC_acceptPresentationContext(
                parameters, context.presentationContextID, syntax.constData());
        } else {
            done = ASC_refusePresentationContext(parameters, context.presentationContextID,
                isKnown ? ASC_P_TRANSFERSYNTAXESNOTSUPPORTED : ASC_P_ABSTRACTSYNTAXNOTSUPPORTED);
        }
        if (done.bad())
            return done;
    }
    return EC_Normal;
}

} // namespace

MoveListener::MoveListener(const PacsNode& node, ObjectIntake& intake)
    : m_node(node)
    , m_intake(intake)
{
    m_wire.progress = &m_ending;
    m_wire.timeoutSeconds = node.timeoutSeconds;
}

Result<std::unique_ptr<MoveListener>> MoveListener::start(
    const PacsNode& node, int port, ObjectIntake& intake)
{
    if (node.tls.wanted()) {
        return failure(ErrorCode::InvalidField, QStringLiteral("move"),
            Clause::saying("with TLS objects come by C-GET only"));
    }
    readyDcmtk();
    std::unique_ptr<MoveListener> listener(new MoveListener(node, intake));
    Result<std::unique_ptr<DcmTransportLayer>> layer = makeWatchedLayer(listener->m_wire, {});
    if (!layer)
        return tl::unexpected<Error>(layer.error());
    listener->m_layer = std::move(*layer);
    const OFCondition open =
        ASC_initializeNetwork(NET_ACCEPTOR, port, node.timeoutSeconds, &listener->m_network);
    if (open.bad()) {
        return failure(ErrorCode::InvalidField, QStringLiteral("move"),
            Clause::saying("nobody can listen on port %1; it may be taken", port));
    }
    ASC_setTransportLayer(listener->m_network, listener->m_layer.get(), 0);
    listener->m_thread.emplace();
    listener->m_thread->post([raw = listener.get()] { raw->work(); },
        [raw = listener.get()](const Error& error) { raw->m_trouble = error; });
    return listener;
}

MoveListener::~MoveListener()
{
    stop();
    if (m_network)
        ASC_dropNetwork(&m_network);
}

std::optional<Error> MoveListener::stop()
{
    m_ending.cancel();
    m_thread.reset();
    return m_trouble;
}

void MoveListener::work()
{
    constexpr auto patience = std::chrono::milliseconds(20);
    while (!m_ending.cancelled()) {
        if (!ASC_associationWaiting(m_network, 0)) {
            std::this_thread::sleep_for(patience);
            continue;
        }
        const Result<void> served = serve();
        // What one caller does wrong does not end the move; a disk that is full does.
        if (!served && served.error().code == ErrorCode::FileUnwritable) {
            m_trouble = served.error();
            return;
        }
    }
}

Result<void> MoveListener::serve()
{
    const Progress* progress = m_wire.progress;
    m_wire = {.progress = progress, .timeoutSeconds = m_node.timeoutSeconds};
    auto parts = std::make_unique<Association::Parts>();
    parts->node = m_node;
    parts->state = &m_wire;
    const OFCondition came = ASC_receiveAssociation(m_network, &parts->association,
        ASC_MAXIMUMPDUSIZE, nullptr, nullptr, OFFalse, DUL_NOBLOCK, m_node.timeoutSeconds);
    Association association(std::move(parts));
    if (came.bad() || !association.get())
        return tl::unexpected<Error>(association.error(came));
    T_ASC_Parameters* parameters = association.get()->params;
    DIC_AE called{};
    DIC_AE calling{};
    DIC_AE responding{};
    ASC_getAPTitles(
        parameters, calling, sizeof calling, called, sizeof called, responding, sizeof responding);
    if (QString::fromLatin1(called).trimmed() != m_node.ownAeTitle) {
        const T_ASC_RejectParameters rejection{ASC_RESULT_REJECTEDPERMANENT, ASC_SOURCE_SERVICEUSER,
            ASC_REASON_SU_CALLEDAETITLENOTRECOGNIZED};
        ASC_rejectAssociation(association.get(), &rejection);
        return {};
    }
    OFCondition accepted = acceptContexts(parameters);
    if (accepted.good())
        accepted = ASC_acknowledgeAssociation(association.get());
    if (accepted.bad())
        return tl::unexpected<Error>(association.error(accepted));
    return converse(association);
}

Result<void> MoveListener::converse(Association& association)
{
    for (;;) {
        T_DIMSE_Message message{};
        T_ASC_PresentationContextID context = 0;
        DcmDataset* detail = nullptr;
        const OFCondition received = DIMSE_receiveCommand(association.get(), DIMSE_NONBLOCKING,
            m_node.timeoutSeconds, &context, &message, &detail);
        delete detail;
        if (received == DUL_PEERREQUESTEDRELEASE) {
            ASC_acknowledgeRelease(association.get());
            association.markReleased();
            return {};
        }
        if (received.bad())
            return tl::unexpected<Error>(association.error(received));
        if (message.CommandField == DIMSE_C_ECHO_RQ) {
            DIMSE_sendEchoResponse(
                association.get(), context, &message.msg.CEchoRQ, STATUS_Success, nullptr);
        } else if (message.CommandField == DIMSE_C_STORE_RQ) {
            Result<void> taken = m_intake.take(association, context, message.msg.CStoreRQ);
            if (!taken)
                return taken;
        } else {
            return failure(ErrorCode::NodeNonsense, m_node.name(),
                Clause::saying("it asks what it should tell"));
        }
    }
}

} // namespace core
