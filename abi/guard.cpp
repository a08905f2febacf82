#include "guard.hpp"

#include "options.hpp"

namespace mien::abi {

void write_error(mien_error* error, mien_status status, std::int64_t detail_index,
                 const char* message) noexcept {
    if (error == nullptr || reinterpret_cast<std::uintptr_t>(error) % alignof(mien_error) != 0)
        return;
    // A record that was zeroed and no more: as large as the first release's at least.
    const std::size_t size =
        error->struct_size != 0 ? error->struct_size : MIEN_FIRST_SIZE(mien_error, message);
    if (size >= offsetof(mien_error, status) + sizeof error->status) error->status = status;
    if (size >= offsetof(mien_error, detail_index) + sizeof error->detail_index)
        error->detail_index = detail_index;
    if (size > offsetof(mien_error, message)) {
        const std::size_t room = size - offsetof(mien_error, message);
        std::snprintf(error->message, room < sizeof error->message ? room : sizeof error->message,
                      "%s", message);
    }
}

void write_budget_error(mien_error* error, const BudgetExceeded& refused) noexcept {
    char text[256];
    std::snprintf(text, sizeof text,
                  "the call needs %zu bytes beside %lld in use, the session's budget is %zu; raise "
                  "max_bytes or use a smaller input",
                  refused.asked_bytes, static_cast<long long>(refused.live_bytes),
                  refused.max_bytes);
    write_error(error, MIEN_E_MEMORY_BUDGET, -1, text);
}

}  // namespace mien::abi

extern "C" const char* MIEN_CALL mien_status_name(mien_status status) {
#define MIEN_STATUS_CASE(name) \
    case name:                 \
        return #name
    switch (status) {
        MIEN_STATUS_CASE(MIEN_OK);
        MIEN_STATUS_CASE(MIEN_E_INVALID_ARGUMENT);
        MIEN_STATUS_CASE(MIEN_E_INVALID_HANDLE);
        MIEN_STATUS_CASE(MIEN_E_INVALID_MESH);
        MIEN_STATUS_CASE(MIEN_E_BUFFER_TOO_SMALL);
        MIEN_STATUS_CASE(MIEN_E_UNSUPPORTED_OPTION);
        MIEN_STATUS_CASE(MIEN_E_UNSUPPORTED_VERSION);
        MIEN_STATUS_CASE(MIEN_E_NO_MEMORY);
        MIEN_STATUS_CASE(MIEN_E_MEMORY_BUDGET);
        MIEN_STATUS_CASE(MIEN_E_IO);
        MIEN_STATUS_CASE(MIEN_E_BAD_FORMAT);
        MIEN_STATUS_CASE(MIEN_E_CORRUPT);
        MIEN_STATUS_CASE(MIEN_E_WRONG_KIND);
        MIEN_STATUS_CASE(MIEN_E_MISMATCH);
        MIEN_STATUS_CASE(MIEN_E_NO_SOLUTION);
        MIEN_STATUS_CASE(MIEN_E_NOT_FOUND);
        MIEN_STATUS_CASE(MIEN_E_CANCELLED);
        MIEN_STATUS_CASE(MIEN_E_CALLBACK);
        MIEN_STATUS_CASE(MIEN_E_INTERNAL);
        MIEN_STATUS_CASE(MIEN_E_BUSY);
        MIEN_STATUS_CASE(MIEN_E_TIME_LIMIT);
        default:
            return "MIEN_E_UNKNOWN";
    }
#undef MIEN_STATUS_CASE
}
