#include "training/trainer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <filesystem>

#include "base/error.hpp"
#include "base/json_text.hpp"
#include "base/json_tree.hpp"
#include "base/random.hpp"
#include "base/safetensors.hpp"
#include "base/sha256.hpp"
#include "training/torch_network.hpp"

namespace mien::training {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Streams of chance, apart from each other and from those of the initial weights.
constexpr std::uint64_t kOrderStream = 0x6f72646572, kNoiseStream = 0x6e6f697365;

/// The faces of an epoch in an order of its own: sorted by a random number each.
std::vector<Index> order_of(std::uint64_t seed, int epoch, Index faces) {
    const CounterRandom chance(seed ^ kOrderStream, static_cast<std::uint64_t>(epoch));
    std::vector<std::pair<double, Index>> keys;
    for (Index k = 0; k < faces; ++k)
        keys.emplace_back(chance.uniform(static_cast<std::uint64_t>(k)), k);
    std::sort(keys.begin(), keys.end());
    std::vector<Index> order;
    for (const auto& key : keys) order.push_back(key.second);
    return order;
}

/// Kingma and Ba 2015, in the form of torch::optim::Adam, with a state that can be saved.
class Adam {
  public:
    explicit Adam(const std::map<std::string, Tensor>& weights) : weights_(weights) {
        for (const auto& [name, weight] : weights_) {
            first_[name] = torch::zeros_like(weight);
            second_[name] = torch::zeros_like(weight);
        }
    }
    void clear_gradients() {
        for (auto& entry : weights_)
            if (entry.second.grad().defined()) entry.second.mutable_grad().zero_();
    }
    void step(double rate, double weight_decay) {
        const torch::NoGradGuard no_gradient;
        ++steps_;
        const double fade_first = 1 - std::pow(kFirst, static_cast<double>(steps_));
        const double fade_second = 1 - std::pow(kSecond, static_cast<double>(steps_));
        for (auto& [name, weight] : weights_) {
            if (!weight.grad().defined()) continue;
            Tensor gradient = weight.grad();
            if (weight_decay != 0) gradient = gradient + weight * weight_decay;
            Tensor& first = first_[name];
            Tensor& second = second_[name];
            first.mul_(kFirst).add_(gradient, 1 - kFirst);
            second.mul_(kSecond).addcmul_(gradient, gradient, 1 - kSecond);
            const Tensor spread = (second / fade_second).sqrt_().add_(1e-8);
            weight.addcdiv_(first, spread, -rate / fade_first);
        }
    }
    std::map<std::string, Tensor>& first() { return first_; }
    std::map<std::string, Tensor>& second() { return second_; }
    std::int64_t steps() const { return steps_; }
    void set_steps(std::int64_t steps) { steps_ = steps; }

  private:
    static constexpr double kFirst = 0.9, kSecond = 0.999;
    std::map<std::string, Tensor> weights_, first_, second_;
    std::int64_t steps_ = 0;
};

/// What a run must have in common with the one that its checkpoint came from.
std::string fingerprint(const NetworkLayers& network, const TrainingData& training,
                        const TrainingSettings& s) {
    Sha256 hash;
    const auto add = [&](const void* data, std::size_t size) { hash.update(data, size); };
    const std::string layers = layers_json(network);
    add(layers.data(), layers.size());
    for (const auto& entry : network.tensors)
        add(entry.second.data, static_cast<std::size_t>(entry.second.count()) * 4);
    add(training.input.data(), training.input.size() * sizeof(float));
    add(training.output.data(), training.output.size() * sizeof(float));
    const double numbers[] = {
        static_cast<double>(s.batch), s.learning_rate, s.decay, s.weight_decay, s.divergence,
        static_cast<double>(s.seed)};
    add(numbers, sizeof numbers);
    return hash.hex_digest();
}

class Trainer {
  public:
    Trainer(const NetworkLayers& network, const TrainingData& training,
            const TrainingData& validation, const TrainingSettings& settings)
        : initial_(network),
          training_(training),
          validation_(validation),
          settings_(settings),
          device_(settings.accelerator ? torch::kCUDA : torch::kCPU),
          model_(network, torch::kFloat32, device_),
          adam_(model_.weights()) {
        result_.last = result_.best = network;
        input_ = all_faces(training.input, training, training.channels);
        target_ =
            training.output.empty() ? input_ : all_faces(training.output, training, channels_out());
        scale_ = blob(training.scale, {1, training.rows, channels_out()}).to(device_);
    }

    TrainingResult run(const std::string& checkpoint, const EpochListener& listener,
                       const std::atomic<bool>& stop) {
        const std::string mark =
            checkpoint.empty() ? "" : fingerprint(initial_, training_, settings_);
        if (!checkpoint.empty() && std::filesystem::exists(checkpoint)) resume(checkpoint, mark);
        const int first = static_cast<int>(result_.epochs.size());
        double spent = 0;
        for (int epoch = first; epoch < settings_.epochs; ++epoch) {
            const Clock::time_point begin = Clock::now();
            EpochRecord record = train_epoch(epoch, stop);
            if (stop) return std::move(result_);  // the epoch is not whole: forgotten
            const bool last = epoch + 1 == settings_.epochs;
            if (validation_.faces > 0 && (last || (epoch + 1) % settings_.validate_every == 0))
                validate(record);
            record.seconds = seconds_since(begin);
            spent += record.seconds;
            result_.epochs.push_back(record);
            model_.write_to(result_.last);
            if (validation_.faces == 0) result_.best = result_.last, result_.best_epoch = epoch + 1;
            if (!checkpoint.empty() && (last || (settings_.checkpoint_every > 0 &&
                                                 (epoch + 1) % settings_.checkpoint_every == 0)))
                save(checkpoint, mark);
            listener(record, spent / (epoch + 1 - first) * (settings_.epochs - epoch - 1));
        }
        result_.finished = true;
        return std::move(result_);
    }

    static Tensor blob(const std::vector<float>& values, std::vector<int64_t> sizes) {
        return torch::from_blob(const_cast<float*>(values.data()), sizes,
                                torch::TensorOptions().dtype(torch::kFloat32))
            .clone();
    }

  private:
    Index channels_out() const { return initial_.decoder.back().channels_out; }
    Tensor all_faces(const std::vector<float>& values, const TrainingData& data, Index channels) {
        return blob(values, {data.faces, data.rows, channels}).to(device_);
    }

    EpochRecord train_epoch(int epoch, const std::atomic<bool>& stop) {
        EpochRecord record;
        record.epoch = epoch + 1;
        const std::vector<Index> order = order_of(settings_.seed, epoch, training_.faces);
        const double rate = settings_.learning_rate * std::pow(settings_.decay, epoch);
        for (std::size_t k = 0; k < order.size() && !stop;
             k += static_cast<std::size_t>(settings_.batch)) {
            const std::size_t count =
                std::min(static_cast<std::size_t>(settings_.batch), order.size() - k);
            std::vector<int64_t> faces(order.begin() + static_cast<std::ptrdiff_t>(k),
                                       order.begin() + static_cast<std::ptrdiff_t>(k + count));
            const Tensor places = torch::tensor(faces, torch::kInt64).to(device_);
            adam_.clear_gradients();
            Tensor divergence;
            const Tensor code = sampled(input_.index_select(0, places), faces, epoch, divergence);
            const Tensor error =
                ((target_.index_select(0, places) - model_.decode(code)) * scale_).abs().mean();
            Tensor loss = error;
            if (divergence.defined()) loss = loss + divergence * settings_.divergence;
            loss.backward();
            const double value = error.item<double>();
            if (!std::isfinite(value))
                fail(Status::no_solution,
                     "the loss is no number in epoch %d; lower the learning rate (%g)", epoch + 1,
                     settings_.learning_rate);
            adam_.step(rate, settings_.weight_decay);
            const double share = static_cast<double>(count) / static_cast<double>(order.size());
            record.training_loss += share * value;
            if (divergence.defined()) record.divergence += share * divergence.item<double>();
        }
        return record;
    }

    /// The code; of a variational network one sample, and the divergence from N(0, I).
    Tensor sampled(const Tensor& x, const std::vector<int64_t>& faces, int epoch,
                   Tensor& divergence) {
        const TorchNetwork::Code code = model_.encode(x);
        if (!code.log_variance.defined()) return code.mean;
        const Tensor log_variance = code.log_variance.clamp(-12, 6);
        Tensor noise = torch::empty(code.mean.sizes(), torch::kFloat32);
        const int64_t size = noise[0].numel();
        float* data = noise.data_ptr<float>();
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const CounterRandom chance(
                settings_.seed ^ kNoiseStream,
                static_cast<std::uint64_t>(epoch) * static_cast<std::uint64_t>(training_.faces) +
                    static_cast<std::uint64_t>(faces[k]));
            for (int64_t i = 0; i < size; ++i)
                *data++ = static_cast<float>(chance.normal(static_cast<std::uint64_t>(i)));
        }
        divergence = 0.5 * (code.mean.square() + log_variance.exp() - 1 - log_variance).sum() /
                     static_cast<double>(faces.size());
        return code.mean + (0.5 * log_variance).exp() * noise.to(device_);
    }

    void validate(EpochRecord& record) {
        const torch::NoGradGuard no_gradient;
        const Tensor input = all_faces(validation_.input, validation_, validation_.channels);
        const Tensor target = validation_.output.empty()
                                  ? input
                                  : all_faces(validation_.output, validation_, channels_out());
        double sum = 0;
        for (int64_t k = 0; k < validation_.faces; k += settings_.batch) {
            const int64_t count = std::min<int64_t>(settings_.batch, validation_.faces - k);
            const Tensor made = model_.decode(model_.encode(input.narrow(0, k, count)).mean);
            sum += ((target.narrow(0, k, count) - made) * scale_).abs().mean().item<double>() *
                   static_cast<double>(count);
        }
        record.validation_loss = sum / static_cast<double>(validation_.faces);
        const bool better = best_loss_ < 0 || record.validation_loss < best_loss_;
        if (!better) return;
        best_loss_ = record.validation_loss;
        result_.best_epoch = record.epoch;
        model_.write_to(result_.best);
    }

    void save(const std::string& path, const std::string& mark) {
        std::vector<Tensor> kept;
        std::vector<TensorToWrite> tensors;
        const auto add = [&](const std::string& name, const Tensor& tensor) {
            kept.push_back(tensor.detach().to(torch::kCPU).contiguous());
            const auto sizes = kept.back().sizes();
            tensors.push_back({name, DType::f32,
                               std::vector<std::uint64_t>(sizes.begin(), sizes.end()),
                               kept.back().data_ptr<float>()});
        };
        for (const auto& [name, weight] : model_.weights()) {
            add("weight." + name, weight);
            add("first." + name, adam_.first().at(name));
            add("second." + name, adam_.second().at(name));
            const NetworkTensor& best = result_.best.tensors.at(name);
            tensors.push_back({"best." + name, best.dtype, best.shape, best.data});
        }
        JsonText json;
        json.begin_object().field("steps", adam_.steps()).field("best_epoch", result_.best_epoch);
        json.field("best_loss", best_loss_).key("epochs").begin_array();
        for (const EpochRecord& record : result_.epochs)
            json.begin_array()
                .number(record.training_loss)
                .number(record.divergence)
                .number(record.validation_loss)
                .number(record.seconds)
                .end_array();
        json.end_array().end_object();
        write_safetensors(path, tensors,
                          {{"kind", "mien-training-state"},
                           {"units", "none"},
                           {"fingerprint", mark},
                           {"state", json.take()}},
                          {});
    }

    void resume(const std::string& path, const std::string& mark) {
        const SafetensorsFile file = SafetensorsFile::open(path, {}, {});
        file.require_kind("mien-training-state");
        if (file.metadata("fingerprint") != mark)
            fail(Status::mismatch,
                 "%.120s is of another network, other faces or other settings; remove it or choose "
                 "another folder",
                 path.c_str());
        const torch::NoGradGuard no_gradient;
        const auto read = [&](const std::string& name, Tensor to) {
            std::vector<std::int64_t> shape(to.sizes().begin(), to.sizes().end());
            const TensorView& view = file.tensor(name, DType::f32, shape);
            to.copy_(torch::from_blob(const_cast<void*>(view.data), to.sizes(),
                                      torch::TensorOptions().dtype(torch::kFloat32)));
        };
        for (const auto& [name, weight] : model_.weights()) {
            read("weight." + name, weight);
            read("first." + name, adam_.first().at(name));
            read("second." + name, adam_.second().at(name));
            const TensorView& best = file.tensor(
                "best." + name, DType::f32,
                std::vector<std::int64_t>(weight.sizes().begin(), weight.sizes().end()));
            const auto* data = static_cast<const float*>(best.data);
            result_.best.tensors[name] =
                make_tensor(best.shape, std::vector<float>(data, data + best.count));
        }
        model_.write_to(result_.last);
        const std::string& text = file.metadata("state");
        const JsonTree state(text.data(), text.size(), "the training state");
        adam_.set_steps(static_cast<std::int64_t>(state.root()["steps"].count("steps")));
        result_.best_epoch = static_cast<int>(state.root()["best_epoch"].count("best_epoch"));
        best_loss_ = state.root()["best_loss"].number("best_loss");
        for (const JsonTree::Value& row : state.root()["epochs"].items()) {
            const std::vector<JsonTree::Value> numbers = row.items();
            if (numbers.size() != 4) fail(Status::bad_format, "%.120s: no epochs", path.c_str());
            EpochRecord record;
            record.epoch = static_cast<int>(result_.epochs.size()) + 1;
            record.training_loss = numbers[0].number("a loss");
            record.divergence = numbers[1].number("a divergence");
            record.validation_loss = numbers[2].number("a loss");
            record.seconds = numbers[3].number("seconds");
            result_.epochs.push_back(record);
        }
    }

    const NetworkLayers& initial_;
    const TrainingData& training_;
    const TrainingData& validation_;
    const TrainingSettings& settings_;
    torch::Device device_;
    TorchNetwork model_;
    Adam adam_;
    Tensor input_, target_, scale_;
    TrainingResult result_;
    double best_loss_ = -1;
};

void check_settings(const TrainingSettings& s) {
    if (s.epochs < 1 || s.batch < 1 || !(s.learning_rate > 0) || !(s.decay > 0 && s.decay <= 1) ||
        !(s.weight_decay >= 0) || !(s.divergence >= 0) || s.threads < 1 || s.validate_every < 1 ||
        s.checkpoint_every < 0)
        fail(
            Status::invalid_argument,
            "training settings out of range: epochs, batch, threads and validate_every are at "
            "least 1, learning_rate above 0, decay above 0 and at most 1, the others not negative");
}

}  // namespace

TrainingResult train(const NetworkLayers& network, const TrainingData& training,
                     const TrainingData& validation, const TrainingSettings& settings,
                     const std::string& checkpoint, const EpochListener& listener,
                     const std::atomic<bool>& stop) {
    check_settings(settings);
    check_layers(network);
    if (network.encoder.empty() || network.decoder.empty() || training.faces < 1)
        fail(Status::invalid_argument, "training needs an encoder, a decoder and faces");
    torch::set_num_threads(settings.threads);
    return Trainer(network, training, validation, settings).run(checkpoint, listener, stop);
}

std::vector<float> reconstruct(const NetworkLayers& network, const TrainingData& data) {
    const torch::NoGradGuard no_gradient;
    const TorchNetwork model(network, torch::kFloat32, torch::kCPU);
    const Tensor made =
        model
            .decode(model.encode(Trainer::blob(data.input, {data.faces, data.rows, data.channels}))
                        .mean)
            .contiguous();
    return std::vector<float>(made.data_ptr<float>(), made.data_ptr<float>() + made.numel());
}

double product_speed() {
    torch::set_num_threads(1);
    const Tensor a = torch::ones({512, 512}), b = torch::ones({512, 512});
    torch::matmul(a, b);                      // loads the library
    const std::clock_t begin = std::clock();  // others may use the processor too
    torch::matmul(a, b);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return 2 * 512.0 * 512 * 512 * 1e-9 / std::max(seconds, 1e-6);
}

}  // namespace mien::training
