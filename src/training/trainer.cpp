#include "training/trainer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <filesystem>
#if !defined(_WIN32)
#include <dlfcn.h>
#endif

#include "base/error.hpp"
#include "base/random.hpp"
#include "training/checkpoint.hpp"

namespace mien::training {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// One network, or two whose decoders take each other's code.
class Trainer {
  public:
    Trainer(const std::vector<BandToTrain>& bands, const TrainingSettings& settings)
        : settings_(settings), device_(settings.accelerator ? torch::kCUDA : torch::kCPU) {
        for (std::size_t b = 0; b < bands.size(); ++b)
            halves_.push_back(std::make_unique<Half>(bands.size() == 1 ? ""
                                                     : b == 0          ? "low."
                                                                       : "high.",
                                                     bands[b], device_));
    }

    TrainingResult run(const std::string& checkpoint, const EpochListener& listener,
                       const std::atomic<bool>& stop) {
        const std::string mark = checkpoint.empty() ? "" : fingerprint(halves_, settings_);
        if (!checkpoint.empty() && std::filesystem::exists(checkpoint))
            resume_checkpoint(checkpoint, mark, halves_, result_, best_loss_);
        const int first = static_cast<int>(result_.epochs.size());
        const bool validated = halves_[0]->validation.faces > 0;
        double spent = 0;
        for (int epoch = first; epoch < settings_.epochs; ++epoch) {
            const Clock::time_point begin = Clock::now();
            EpochRecord record = train_epoch(epoch, stop);
            if (stop) return finished(false);  // the epoch is not whole: forgotten
            const bool last = epoch + 1 == settings_.epochs;
            if (validated && (last || (epoch + 1) % settings_.validate_every == 0))
                validate(record);
            record.seconds = seconds_since(begin);
            spent += record.seconds;
            result_.epochs.push_back(record);
            for (auto& half : halves_) {
                half->model.write_to(half->last);
                if (!validated) half->best = half->last;
            }
            if (!validated) result_.best_epoch = epoch + 1;
            if (!checkpoint.empty() && (last || (settings_.checkpoint_every > 0 &&
                                                 (epoch + 1) % settings_.checkpoint_every == 0)))
                save_checkpoint(checkpoint, mark, halves_, result_, best_loss_);
            listener(record, spent / (epoch + 1 - first) * (settings_.epochs - epoch - 1));
        }
        return finished(true);
    }

  private:
    TrainingResult finished(bool whole) {
        result_.finished = whole;
        result_.last = std::move(halves_[0]->last);
        result_.best = std::move(halves_[0]->best);
        if (halves_.size() > 1) {
            result_.high_last = std::move(halves_[1]->last);
            result_.high_best = std::move(halves_[1]->best);
        }
        return std::move(result_);
    }

    EpochRecord train_epoch(int epoch, const std::atomic<bool>& stop) {
        EpochRecord record;
        record.epoch = epoch + 1;
        const std::vector<Index> order =
            order_of(settings_.seed, epoch, halves_[0]->training.faces);
        for (std::size_t k = 0; k < order.size() && !stop;
             k += static_cast<std::size_t>(settings_.batch)) {
            const std::size_t count =
                std::min(static_cast<std::size_t>(settings_.batch), order.size() - k);
            const std::vector<int64_t> faces(
                order.begin() + static_cast<std::ptrdiff_t>(k),
                order.begin() + static_cast<std::ptrdiff_t>(k + count));
            step(faces, epoch, static_cast<double>(count) / static_cast<double>(order.size()),
                 record);
        }
        return record;
    }

    void step(const std::vector<int64_t>& faces, int epoch, double share, EpochRecord& record) {
        const Tensor places = torch::tensor(faces, torch::kInt64).to(device_);
        std::vector<Tensor> codes, divergences(halves_.size());
        for (std::size_t b = 0; b < halves_.size(); ++b) {
            halves_[b]->adam.clear_gradients();
            codes.push_back(sampled(b, halves_[b]->input.index_select(0, places), faces, epoch,
                                    divergences[b]));
        }
        Tensor loss;
        double* const losses[] = {&record.training_loss, &record.high_training_loss};
        for (std::size_t b = 0; b < halves_.size(); ++b) {
            Half& half = *halves_[b];
            Tensor code = codes[b];
            if (halves_.size() > 1) code = joined(code, dropped(b, codes[1 - b], faces, epoch));
            const Tensor error =
                ((half.target.index_select(0, places) - half.model.decode(code)) * half.scale)
                    .abs()
                    .mean();
            const double value = error.item<double>();
            if (!std::isfinite(value))
                fail(Status::no_solution,
                     "the loss is no number in epoch %d; lower the learning rate (%g)", epoch + 1,
                     settings_.learning_rate);
            *losses[b] += share * value;
            Tensor own = error;
            if (divergences[b].defined()) {
                own = own + divergences[b] * settings_.divergence;
                record.divergence += share * divergences[b].item<double>();
            }
            // No weight stands in both: one pass gives each network its own gradient.
            loss = loss.defined() ? loss + own : own;
        }
        loss.backward();
        const double rate = settings_.learning_rate * std::pow(settings_.decay, epoch);
        for (auto& half : halves_) half->adam.step(rate, settings_.weight_decay);
    }

    /// Number of a face in an epoch, for its own stream of chance.
    std::uint64_t sample_number(int64_t face, int epoch) const {
        return static_cast<std::uint64_t>(epoch) *
                   static_cast<std::uint64_t>(halves_[0]->training.faces) +
               static_cast<std::uint64_t>(face);
    }
    /// One number for each element of a batch of codes: draw(chance, element).
    template <typename Draw>
    Tensor random_like(const Tensor& code, const std::vector<int64_t>& faces, int epoch,
                       std::uint64_t stream, const Draw& draw) const {
        Tensor values = torch::empty(code.sizes(), torch::kFloat32);
        const int64_t size = values[0].numel();
        float* data = values.data_ptr<float>();
        for (const int64_t face : faces) {
            const CounterRandom chance(settings_.seed ^ stream, sample_number(face, epoch));
            for (int64_t i = 0; i < size; ++i)
                *data++ = static_cast<float>(draw(chance, static_cast<std::uint64_t>(i)));
        }
        return values.to(device_);
    }

    /// The code; of a variational network one sample, and the divergence from N(0, I).
    Tensor sampled(std::size_t b, const Tensor& x, const std::vector<int64_t>& faces, int epoch,
                   Tensor& divergence) {
        if (settings_.frozen_encoder) {
            const torch::NoGradGuard no_gradient;
            return halves_[b]->model.encode(x).mean;
        }
        const TorchNetwork::Code code = halves_[b]->model.encode(x);
        if (!code.log_variance.defined()) return code.mean;
        const Tensor log_variance = code.log_variance.clamp(-12, 6);
        const Tensor noise = random_like(
            code.mean, faces, epoch, kNoiseStream + b,
            [](const CounterRandom& chance, std::uint64_t i) { return chance.normal(i); });
        divergence = 0.5 * (code.mean.square() + log_variance.exp() - 1 - log_variance).sum() /
                     static_cast<double>(faces.size());
        return code.mean + (0.5 * log_variance).exp() * noise;
    }

    /// The other band's code as decoder b sees it in training.
    Tensor dropped(std::size_t b, const Tensor& other, const std::vector<int64_t>& faces,
                   int epoch) const {
        const Tensor code = other.detach();
        const double kept = settings_.conditioning;
        if (kept >= 1) return code;
        if (kept <= 0) return torch::zeros_like(code);
        return code * random_like(code, faces, epoch, kDropStream + b,
                                  [kept](const CounterRandom& chance, std::uint64_t i) {
                                      return chance.uniform(i) < kept ? 1 / kept : 0.0;
                                  });
    }
    static Tensor joined(const Tensor& own, const Tensor& other) {
        return torch::cat({own, other}, 2);
    }

    void validate(EpochRecord& record) {
        const torch::NoGradGuard no_gradient;
        double sums[2] = {0, 0};
        const Index count_all = halves_[0]->validation.faces;
        for (int64_t k = 0; k < count_all; k += settings_.batch) {
            const int64_t count = std::min<int64_t>(settings_.batch, count_all - k);
            std::vector<Tensor> codes;
            for (const auto& half : halves_)
                codes.push_back(half->model.encode(slice(*half, false, k, count)).mean);
            for (std::size_t b = 0; b < halves_.size(); ++b) {
                Tensor code = codes[b];
                if (halves_.size() > 1)
                    code =
                        joined(code, settings_.conditioning > 0 ? codes[1 - b]
                                                                : torch::zeros_like(codes[1 - b]));
                const Half& half = *halves_[b];
                sums[b] += ((slice(half, true, k, count) - half.model.decode(code)) * half.scale)
                               .abs()
                               .mean()
                               .item<double>() *
                           static_cast<double>(count);
            }
        }
        record.validation_loss = sums[0] / static_cast<double>(count_all);
        if (halves_.size() > 1)
            record.high_validation_loss = sums[1] / static_cast<double>(count_all);
        const double now = relative_loss(record);
        if (best_loss_ >= 0 && !(now < best_loss_)) return;
        best_loss_ = now;
        result_.best_epoch = record.epoch;
        for (auto& half : halves_) half->model.write_to(half->best);
    }

    /// Validation faces [first, first + count): what goes in, or what should come out.
    Tensor slice(const Half& half, bool target, int64_t first, int64_t count) const {
        const TrainingData& data = half.validation;
        const bool other = target && !data.output.empty();
        const Index channels = other ? half.channels_out() : data.channels;
        const std::vector<float>& values = other ? data.output : data.input;
        const auto size = static_cast<std::size_t>(data.rows * channels);
        const auto begin =
            values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first) * size);
        const std::vector<float> part(
            begin, begin + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(count) * size));
        return Half::blob(part, {count, data.rows, channels}).to(device_);
    }

    /// The losses of two bands have different units: each counts in its first value.
    double relative_loss(const EpochRecord& record) const {
        if (halves_.size() == 1) return record.validation_loss;
        EpochRecord first = record;
        for (const EpochRecord& earlier : result_.epochs)
            if (earlier.validation_loss >= 0) {
                first = earlier;
                break;
            }
        return record.validation_loss / std::max(first.validation_loss, 1e-30) +
               record.high_validation_loss / std::max(first.high_validation_loss, 1e-30);
    }

    const TrainingSettings& settings_;
    torch::Device device_;
    Halves halves_;
    TrainingResult result_;
    double best_loss_ = -1;
};

void check_settings(const TrainingSettings& s) {
    if (s.epochs < 1 || s.batch < 1 || !(s.learning_rate > 0) || !(s.decay > 0 && s.decay <= 1) ||
        !(s.weight_decay >= 0) || !(s.divergence >= 0) || s.threads < 1 || s.validate_every < 1 ||
        s.checkpoint_every < 0 || !(s.conditioning >= 0 && s.conditioning <= 1))
        fail(
            Status::invalid_argument,
            "training settings out of range: epochs, batch, threads and validate_every are at "
            "least 1, learning_rate above 0, decay above 0 and at most 1, conditioning 0 to 1, the "
            "others not negative");
}

void check_band(const BandToTrain& band, bool paired) {
    check_layers(band.network);
    if (band.network.encoder.empty() || band.network.decoder.empty() || band.training.faces < 1)
        fail(Status::invalid_argument, "training needs an encoder, a decoder and faces");
    if ((band.network.condition != 0) != paired)
        fail(Status::invalid_argument,
             "a decoder that takes another code is trained with the network that gives it");
}

/// For libtorch, and for the OpenBLAS beneath it, which has threads of its own: one for every core
/// unless it is told, and those that have nothing to do look for work all the time.
void use_threads(int threads) {
    torch::set_num_threads(threads);
#if !defined(_WIN32)
    using SetThreads = void (*)(int);
    static const auto set_threads =
        reinterpret_cast<SetThreads>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
    if (set_threads != nullptr) set_threads(threads);
#endif
}

}  // namespace

TrainingResult train(const NetworkLayers& network, const TrainingData& training,
                     const TrainingData& validation, const TrainingSettings& settings,
                     const std::string& checkpoint, const EpochListener& listener,
                     const std::atomic<bool>& stop) {
    check_settings(settings);
    const BandToTrain band{network, training, validation};
    check_band(band, false);
    use_threads(settings.threads);
    return Trainer({band}, settings).run(checkpoint, listener, stop);
}

TrainingResult train_bands(const BandToTrain& low, const BandToTrain& high,
                           const TrainingSettings& settings, const std::string& checkpoint,
                           const EpochListener& listener, const std::atomic<bool>& stop) {
    check_settings(settings);
    check_band(low, true);
    check_band(high, true);
    if (low.training.faces != high.training.faces || low.validation.faces != high.validation.faces)
        fail(Status::invalid_argument, "the bands are of different faces");
    use_threads(settings.threads);
    return Trainer({low, high}, settings).run(checkpoint, listener, stop);
}

std::vector<float> reconstruct(const NetworkLayers& network, const TrainingData& data) {
    const torch::NoGradGuard no_gradient;
    const TorchNetwork model(network, torch::kFloat32, torch::kCPU);
    const Tensor made =
        model
            .decode(
                model.encode(Half::blob(data.input, {data.faces, data.rows, data.channels})).mean)
            .contiguous();
    return std::vector<float>(made.data_ptr<float>(), made.data_ptr<float>() + made.numel());
}

std::vector<float> reconstruct_bands(const BandToTrain& low, const BandToTrain& high,
                                     double conditioning) {
    const torch::NoGradGuard no_gradient;
    const auto code_of = [](const BandToTrain& band) {
        const TorchNetwork model(band.network, torch::kFloat32, torch::kCPU);
        const TrainingData& data = band.training;
        return model.encode(Half::blob(data.input, {data.faces, data.rows, data.channels})).mean;
    };
    const Tensor own = code_of(low);
    Tensor other = code_of(high);
    if (!(conditioning > 0)) other = torch::zeros_like(other);
    const TorchNetwork model(low.network, torch::kFloat32, torch::kCPU);
    const Tensor made = model.decode(torch::cat({own, other}, 2)).contiguous();
    return std::vector<float>(made.data_ptr<float>(), made.data_ptr<float>() + made.numel());
}

double product_speed() {
    use_threads(1);
    const Tensor a = torch::ones({512, 512}), b = torch::ones({512, 512});
    torch::matmul(a, b);                      // loads the library
    const std::clock_t begin = std::clock();  // others may use the processor too
    torch::matmul(a, b);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return 2 * 512.0 * 512 * 512 * 1e-9 / std::max(seconds, 1e-6);
}

}  // namespace mien::training
