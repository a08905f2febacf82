#include "registration/batch.hpp"

#include <algorithm>
#include <new>

#include "base/memory_budget.hpp"
#include "base/parallel.hpp"

namespace mien {
namespace {

bool ends_all(Status status) {
    return status == Status::cancelled || status == Status::callback ||
           status == Status::time_limit;
}

BatchOutcome run_job(const DeformationModel& model, const BatchJob& job, const Context& context) {
    BatchOutcome outcome;
    try {
        outcome.fit = std::make_unique<RegistrationResult>(
            register_scan(model, *job.scan, job.landmarks, job.settings, context));
    } catch (const Error& error) {
        if (ends_all(error.status())) throw;
        outcome.status = error.status();
        outcome.message = error.what();
    } catch (const BudgetExceeded&) {
        outcome.status = Status::memory_budget;
        outcome.message = "this scan beside the others exceeds the memory budget";
    } catch (const std::bad_alloc&) {
        outcome.status = Status::no_memory;
        outcome.message = "out of memory for this scan";
    }
    return outcome;
}

}  // namespace

std::vector<BatchOutcome> register_batch(const DeformationModel& model,
                                         const std::vector<BatchJob>& jobs,
                                         const Context& context) {
    constexpr std::size_t kPerThread = 8;  // between two reports of progress
    std::vector<BatchOutcome> outcomes(jobs.size());
    Context inside = context;
    inside.progress_function = nullptr;  // of one scan, and on a thread that may not report
    inside.log_function = nullptr;
    const std::size_t threads =
        context.pool == nullptr ? 1 : static_cast<std::size_t>(context.pool->num_threads());
    const std::size_t portion = kPerThread * threads;
    for (std::size_t first = 0; first < jobs.size(); first += portion) {
        context.progress(Stage::fitting,
                         static_cast<double>(first) / static_cast<double>(jobs.size()));
        const std::size_t count = std::min(portion, jobs.size() - first);
        if (count < threads) {  // each with all threads, one after the other
            for (std::size_t k = first; k < first + count; ++k)
                outcomes[k] = run_job(model, jobs[k], inside);
            continue;
        }
        Context alone = inside;
        alone.pool = nullptr;
        parallel_for(context, count, 1, [&](std::size_t k, std::size_t) {
            outcomes[first + k] = run_job(model, jobs[first + k], alone);
        });
    }
    context.progress(Stage::fitting, 1);
    return outcomes;
}

}  // namespace mien
