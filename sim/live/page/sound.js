// sound.js - plays what arrives, at the rate of the audio context.
//
// When the simulation is slower than real time samples are missing: what is heard then is silence,
// from the last sample down to 0 within 5 ms, and sound goes on when 60 ms have gathered again.
class BoardSound extends AudioWorkletProcessor {
    constructor() {
        super();
        this.queue = [];       // pairs at the codec's rate
        this.rate = 8000;
        this.position = 0;     // between queue[0] and queue[1]
        this.waiting = true;
        this.last = [0, 0];
        this.heard = 0;
        this.port.onmessage = ({data}) => {
            this.rate = data.rate || 8000;
            for (let i = 0; i + 1 < data.samples.length; i += 2)
                this.queue.push([data.samples[i] / 32768, data.samples[i + 1] / 32768]);
            const most = this.rate / 4;  // later than a quarter of a second is too late
            if (this.queue.length > most) this.queue.splice(0, this.queue.length - most);
        };
    }

    process(inputs, [[left, right]]) {
        const fall = Math.exp(-1 / (0.005 * sampleRate));
        for (let i = 0; i < left.length; ++i) {
            if (this.waiting) this.waiting = this.queue.length < 0.06 * this.rate;
            if (!this.waiting && this.queue.length < 2) this.waiting = true;
            if (this.waiting) {
                this.last = this.last.map((x) => x * fall);
            } else {
                const [a, b] = this.queue, t = this.position;
                this.last = [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
                this.position += this.rate / sampleRate;
                while (this.position >= 1 && this.queue.length > 1) {
                    this.position -= 1;
                    this.queue.shift();
                    ++this.heard;
                }
            }
            left[i] = this.last[0];
            if (right) right[i] = this.last[1];
        }
        this.port.postMessage(this.heard);
        return true;
    }
}

registerProcessor("board-sound", BoardSound);
